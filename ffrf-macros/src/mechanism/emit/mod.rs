//! The code of a mechanism: its model, its states, and what integrators need of it.

mod assembly;
mod branches;
mod forces;
mod model;
mod plan;
mod rooms;
mod sensors;
mod states;
mod straight;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::Ident;

use super::bodies::Body;
use super::spec::Spec;
use crate::parse::Input;

/// Everything.
pub(super) fn mechanism(input: &Input, spec: &Spec) -> TokenStream {
    let names = Names::new(&input.name);
    let model = model::model(input, &names, spec);
    let states = states::states(input, &names, spec);
    let sensors = sensors::sensors(&names, spec);
    let assembly = assembly::assembly(&names, spec);
    quote! { #model #states #sensors #assembly }
}

/// The names of the types.
struct Names {
    model: Ident,
    state: Ident,
    increment: Ident,
    ports: Ident,
}

impl Names {
    fn new(name: &Ident) -> Self {
        Self {
            model: name.clone(),
            state: format_ident!("{name}State", span = name.span()),
            increment: format_ident!("{name}Increment", span = name.span()),
            ports: format_ident!("{name}Ports", span = name.span()),
        }
    }
}

/// What one body contributes: a field of this type, or an array of them.
fn field_type(body: &Body, one: &TokenStream) -> TokenStream {
    match body.count {
        Some(count) => quote! { [#one; #count] },
        None => one.clone(),
    }
}

/// The field of a body in `owner`, as a slice.
fn slice(body: &Body, owner: &TokenStream) -> TokenStream {
    let name = &body.name;
    match body.count {
        Some(_) => quote! { #owner.#name.as_slice() },
        None => quote! { ::core::slice::from_ref(&#owner.#name) },
    }
}

/// The field of a body in `owner`, as a slice to write to.
fn slice_mut(body: &Body, owner: &TokenStream) -> TokenStream {
    let name = &body.name;
    match body.count {
        Some(_) => quote! { #owner.#name.as_mut_slice() },
        None => quote! { ::core::slice::from_mut(&mut #owner.#name) },
    }
}

/// The type of the modal vector of a body.
fn modal(body: &Body, spec: &Spec) -> TokenStream {
    let (kind, t) = (body.kind(&spec.scalar), spec.scalar.name());
    quote! { <#kind as ::ffrf::FlexibleBody<#t>>::Modal }
}

/// Which of the bodies of a field have many joints, counted from its first.
fn hubs_of(body: &Body, spec: &Spec) -> Vec<usize> {
    let here = body.first..body.first + body.len();
    spec.hubs.iter().filter(|hub| here.contains(&hub.body)).map(|hub| hub.body - body.first).collect()
}

/// The field of a model that holds the markers used on a body.
fn markers_of(body: &Body) -> Ident {
    format_ident!("markers_of_{}", body.name)
}
