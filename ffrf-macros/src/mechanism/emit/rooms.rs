//! Room for what the equations need of each body.

use proc_macro2::TokenStream;
use quote::quote;

use super::{field_type, hubs_of, modal};
use crate::mechanism::bodies::Body;
use crate::mechanism::spec::Spec;

/// What a room of a body depends on besides its modes: the type of its rows, and of the modes that it keeps.
pub(super) fn room_parameters(body: &Body, spec: &Spec) -> [TokenStream; 2] {
    let (modal, t) = (modal(body, spec), spec.scalar.name());
    let rows = (body.first..body.first + body.len())
        .map(|index| spec.soft.as_ref().map_or(&spec.plan, |(plans, _)| plans).attached_ends(index))
        .max()
        .unwrap_or(0);
    let rows = quote! { [::core::option::Option<::ffrf::mechanism::AttachedRows<#modal, #t>>; #rows] };
    let kept = if hubs_of(body, spec).is_empty() {
        quote! { () }
    } else {
        quote! { ::core::option::Option<::ffrf::mechanism::KeptModes<#modal, #t>> }
    };
    [rows, kept]
}

/// The type of the rooms of all bodies, in their order, and rooms that are absent.
pub(super) fn rooms(spec: &Spec) -> [TokenStream; 2] {
    let t = spec.scalar.name();
    let types = spec.bodies.iter().map(|body| {
        let (modal, [rows, kept]) = (modal(body, spec), room_parameters(body, spec));
        let room = quote! { ::ffrf::mechanism::Room<#modal, #rows, #t, #kept> };
        field_type(body, &quote! { ::core::option::Option<#room> })
    });
    let absent = spec.bodies.iter().map(|body| match body.count {
        Some(_) => quote! { support::absent() },
        None => quote! { ::core::option::Option::None },
    });
    [quote! { (#(#types,)*) }, quote! { (#(#absent,)*) }]
}
