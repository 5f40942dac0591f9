//! The bodies of a tree in the order of a sweep, as constants.

use ffrf_codegen::mechanism::BranchPlace;
use proc_macro2::TokenStream;
use quote::quote;

use crate::mechanism::spec::Spec;

/// The branches of a mechanism that is a tree, in code.
pub(super) struct Branches {
    /// The constants.
    pub(super) constants: TokenStream,
    /// The branches made of them, as an expression: none if bodies have too many modes.
    pub(super) list: TokenStream,
    /// Number of branches, and of their motions.
    pub(super) counts: [TokenStream; 2],
}

/// The branches; `None` if joints close loops.
pub(super) fn branches(spec: &Spec) -> Option<Branches> {
    let places = &spec.branches;
    if places.is_empty() {
        return None;
    }
    let count = places.len();
    let motions: usize = places.iter().map(|branch| branch.freedoms).sum();
    let branches = places.iter().map(branch);
    let mut constants = quote! { static BRANCHES: [places::Branch; #count] = [#(#branches),*]; };
    let flexible = spec.bodies.iter().filter(|body| body.is_flexible());
    let modes: Vec<_> = flexible.map(|body| body.mode_count(spec.scalar)).collect();
    if modes.is_empty() {
        let counts = [count, motions].map(|count| quote! { #count });
        return Some(Branches { constants, list: quote! { &BRANCHES }, counts });
    }
    constants.extend(quote! {
        /// Whether bodies have so few modes that a sweep over them costs less than the equations of all joints.
        const SWEEPS: bool = places::sweeps(&[#(#modes),*]);
    });
    let counts = [count, motions].map(|count| quote! { { if SWEEPS { #count } else { 0 } } });
    Some(Branches { constants, list: quote! { if SWEEPS { BRANCHES.as_slice() } else { &[] } }, counts })
}

fn branch(place: &BranchPlace) -> TokenStream {
    let number = |number: Option<usize>| match number {
        None => quote! { ::core::option::Option::None },
        Some(number) => quote! { ::core::option::Option::Some(#number) },
    };
    let (body, joint, parent) = (place.body, number(place.joint), number(place.parent));
    let (is_second, freedom, freedoms) = (place.is_second, place.freedom, place.freedoms);
    quote! {
        places::Branch {
            body: #body, joint: #joint, is_second: #is_second, parent: #parent,
            freedom: #freedom, freedoms: #freedoms,
        }
    }
}
