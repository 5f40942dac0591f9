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
    /// Statements that add the energy that they store to `sum`.
    pub(super) stored: TokenStream,
    /// The method that finds friction that follows reactions, if there is any.
    pub(super) friction: TokenStream,
    /// The method that finds what implicit steps take into their matrix, if there is any.
    pub(super) soft: TokenStream,
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
    let mut count = 0;
    let mut arms = TokenStream::new();
    for Force { name, range, nature } in &spec.forces {
        let Nature::Friction { .. } = nature else { continue };
        let first = count;
        count += range.as_ref().map_or(1, crate::mechanism::call::Range::len);
        let last = count - 1;
        arms.extend(match range {
            None => quote! { #first => ::core::option::Option::Some(self.#name), },
            Some(_) => quote! { #first..=#last => self.#name.get(index - #first).copied(), },
        });
    }
    let friction = if count == 0 {
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
    Acting { applied, stored: stored(spec), friction, soft: soft(spec) }
}

/// What adds the energy of force elements to `sum`.
fn stored(spec: &Spec) -> TokenStream {
    let elements = spec.forces.iter().filter(|force| matches!(force.nature, Nature::Element { .. }));
    let mut added = elements
        .map(|force| {
            let field = &force.name;
            match &force.range {
                None => quote! { sum.potential += self.#field.energy(&ports); },
                Some(_) => {
                    quote! { for element in &self.#field { sum.potential += element.energy(&ports); } }
                }
            }
        })
        .peekable();
    if added.peek().is_none() {
        return TokenStream::new();
    }
    quote! {
        let mut rooms = ::ffrf::mechanism::Assembly::rooms(self);
        let ports = ::ffrf::mechanism::Assembly::ports(self, &mut rooms, *state, ::core::option::Option::None);
        #(#added)*
    }
}

/// The number of frictions that follow reactions.
pub(super) fn friction_count(spec: &Spec) -> usize {
    let frictions = spec.forces.iter().filter(|force| matches!(force.nature, Nature::Friction { .. }));
    frictions.map(|force| force.range.as_ref().map_or(1, crate::mechanism::call::Range::len)).sum()
}

/// The method that finds soft links.
fn soft(spec: &Spec) -> TokenStream {
    let t = spec.scalar.name();
    let (mut count, mut arms) = (0, TokenStream::new());
    for force in spec.forces.iter().filter(|force| force.soft_row_count().is_some()) {
        let (name, first) = (&force.name, count);
        count += force.range.as_ref().map_or(1, crate::mechanism::call::Range::len);
        let last = count - 1;
        arms.extend(match &force.range {
            None => quote! { #first => ::core::option::Option::Some(self.#name.soft()), },
            Some(_) => quote! {
                #first..=#last => self.#name.get(index - #first).map(::ffrf::mechanism::Element::soft),
            },
        });
    }
    if count == 0 {
        return TokenStream::new();
    }
    quote! {
        fn soft_plan(&self) -> ::ffrf::mechanism::Plan<'_> {
            soft_plan()
        }

        fn soft(&self, index: usize) -> ::core::option::Option<::ffrf::mechanism::SoftLink<'_, #t>> {
            match index {
                #arms
                _ => ::core::option::Option::None,
            }
        }
    }
}
