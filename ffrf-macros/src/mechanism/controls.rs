//! Controls: numbers of the model that forces of the user's own read.

use proc_macro2::TokenStream;
use quote::quote;
use syn::punctuated::Punctuated;
use syn::{FieldValue, Ident, Member, Token};

use super::call::braces;
use super::scalar::Scalar;
use crate::parse::Field;

/// A control and its value when the model is made.
pub(super) struct Control {
    pub(super) name: Ident,
    /// The value as an expression.
    pub(super) value: TokenStream,
}

/// The controls of `controls: { name: value, ... }`.
pub(super) fn controls(field: &Field, scalar: Scalar) -> syn::Result<Vec<Control>> {
    braces(field.value.clone(), |input| {
        let all = Punctuated::<FieldValue, Token![,]>::parse_terminated(input)?;
        all.into_iter().map(|control| one(control, scalar)).collect()
    })
}

fn one(FieldValue { member, expr, .. }: FieldValue, scalar: Scalar) -> syn::Result<Control> {
    match member {
        Member::Named(name) => Ok(Control { name, value: scalar.number(&quote! { #expr }) }),
        Member::Unnamed(index) => Err(syn::Error::new(index.span, "a control has a name")),
    }
}
