//! Forces as fields of the model, and what they add to the equations.

use proc_macro2::TokenStream;
use quote::quote;

use super::Names;
use crate::mechanism::call::{each, each_type};
use crate::mechanism::forces::{Force, Nature};
use crate::mechanism::spec::Spec;

/// The fields of the model.
pub(super) fn fields(names: &Names, spec: &Spec) -> TokenStream {
    let (t, used, model, ports) = (spec.scalar.name(), spec.scalar.used(), &names.model, &names.ports);
    let in_state = match spec.scalar {
        crate::mechanism::scalar::Scalar::Generic => quote! { <'_, T> },
        _ => quote! { <'_> },
    };
    let fields = spec.forces.iter().map(|force| {
        let (field, doc) = (&force.name, format!("Force `{}`.", force.name));
        let kind = match &force.nature {
            Nature::Element { type_name, .. } => {
                let kind = syn::Ident::new(type_name, field.span());
                quote! { ::ffrf::mechanism::Element<::ffrf::forces::#kind<#t>, #t> }
            }
            Nature::Friction { .. } => quote! { ::ffrf::mechanism::JointFriction<#t> },
            Nature::User { .. } => quote! { fn(&#model #used, #t, &mut #ports #in_state) },
        };
        let kind = each_type(force.range.as_ref(), kind);
        quote! { #[doc = #doc] pub #field: #kind, }
    });
    quote! { #(#fields)* }
}

/// The values of these fields in a new model.
pub(super) fn values(spec: &Spec) -> impl Iterator<Item = TokenStream> + '_ {
    spec.forces.iter().map(|force| {
        let field = &force.name;
        let value = match &force.nature {
            Nature::Element { kind, attachments: [first, second], .. } => {
                quote! { ::ffrf::mechanism::Element { kind: #kind, first: #first, second: #second } }
            }
            Nature::Friction { value } => value.clone(),
            Nature::User { function } => function.clone(),
        };
        let value = each(force.range.as_ref(), value);
        quote! { #field: #value }
    })
}

/// What forces do to the implementation of `Assembly`.
pub(super) struct Acting {
    /// Statements that add them to the forces on the bodies.
    pub(super) applied: TokenStream,
    /// The method that finds friction that follows reactions, if there is any.
    pub(super) friction: TokenStream,
    pub(super) friction_count: usize,
}

/// What the forces of a mechanism do.
pub(super) fn forces(spec: &Spec) -> Acting {
    let t = spec.scalar.name();
    let applied = spec.forces.iter().map(|force| {
        let field = &force.name;
        match (&force.nature, &force.range) {
            (Nature::Element { .. }, None) => quote! { self.#field.apply(ports); },
            (Nature::Element { .. }, Some(_)) => {
                quote! { for element in &self.#field { element.apply(ports); } }
            }
            (Nature::Friction { .. }, _) => TokenStream::new(),
            (Nature::User { .. }, _) => quote! { (self.#field)(self, time, ports); },
        }
    });
    let applied = quote! { #(#applied)* };
    let mut friction_count = 0;
    let mut arms = TokenStream::new();
    for Force { name, range, nature } in &spec.forces {
        let Nature::Friction { .. } = nature else { continue };
        let first = friction_count;
        friction_count += range.as_ref().map_or(1, crate::mechanism::call::Range::len);
        let last = friction_count - 1;
        arms.extend(match range {
            None => quote! { #first => ::core::option::Option::Some(self.#name), },
            Some(_) => quote! { #first..=#last => self.#name.get(index - #first).copied(), },
        });
    }
    let friction = if friction_count == 0 {
        TokenStream::new()
    } else {
        quote! {
            fn friction(&self, index: usize) -> ::core::option::Option<::ffrf::mechanism::JointFriction<#t>> {
                match index {
                    #arms
                    _ => ::core::option::Option::None,
                }
            }
        }
    };
    Acting { applied, friction, friction_count }
}
