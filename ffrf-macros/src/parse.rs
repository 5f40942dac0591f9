//! What the user wrote: attributes, the head of a struct or family, and `key: value` fields with their places.

use proc_macro2::{Span, TokenStream};
use syn::parse::{Parse, ParseStream};
use syn::{Attribute, Ident, Token, Visibility, braced};

/// `#[...] pub struct NAME { key: value, ... }`, or `family` in the place of `struct`.
pub(crate) struct Input {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) is_family: bool,
    pub(crate) name: Ident,
    pub(crate) fields: Vec<Field>,
}

syn::custom_keyword!(family);

/// `key: value`, the value as written.
#[derive(Clone)]
pub(crate) struct Field {
    pub(crate) key: Ident,
    pub(crate) value: TokenStream,
    pub(crate) span: Span,
}

impl Parse for Input {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let attributes = input.call(Attribute::parse_outer)?;
        let visibility = input.parse()?;
        let is_family = input.peek(family);
        if is_family {
            input.parse::<family>()?;
        } else {
            input.parse::<Token![struct]>()?;
        }
        let name = input.parse()?;
        let content;
        braced!(content in input);
        let mut fields = Vec::new();
        while !content.is_empty() {
            fields.push(content.parse()?);
            if content.is_empty() {
                break;
            }
            content.parse::<Token![,]>()?;
        }
        Ok(Self { attributes, visibility, is_family, name, fields })
    }
}

impl Parse for Field {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let key: Ident = input.parse()?;
        input.parse::<Token![:]>()?;
        let mut value = TokenStream::new();
        while !input.is_empty() && !input.peek(Token![,]) {
            value.extend([input.parse::<proc_macro2::TokenTree>()?]);
        }
        let span = value.clone().into_iter().next().map_or(key.span(), |token| token.span());
        Ok(Self { key, value, span })
    }
}
