//! Accelerations by a function that was printed for the mechanism: its arguments, and what its result is to integrators.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::spanned::Spanned as _;

use super::{Names, slice, slice_mut};
use crate::mechanism::bodies::Body;
use crate::mechanism::spec::Spec;

/// `Assembly::straight_rates`, if the mechanism has such a function.
pub(super) fn straight_rates(names: &Names, spec: &Spec) -> Option<TokenStream> {
    let path = spec.accelerations.as_ref()?;
    let (state, t, connections) = (&names.state, spec.scalar.name(), spec.connections);
    let body_count: usize = spec.bodies.iter().map(Body::len).sum();
    let put = spec.bodies.iter().map(|body| {
        let states = slice(body, &quote! { state });
        quote! { for state in #states { support::put_state(state, &mut places); } }
    });
    let driven = spec.drives.iter().map(|drive| {
        let (field, first) = (&drive.name, drive.first);
        let each = match &drive.range {
            Some(_) => quote! { self.#field.as_slice() },
            None => quote! { ::core::slice::from_ref(&self.#field) },
        };
        quote! {
            for (place, drive) in drives.iter_mut().skip(#first).zip(#each) {
                *place = drive.at(time);
            }
        }
    });
    let rates = spec.bodies.iter().map(|body| {
        let (own, states) = (slice_mut(body, &quote! { rates }), slice(body, &quote! { state }));
        quote! {
            for (own, state) in #own.iter_mut().zip(#states) {
                *own = support::rate_with(own, state, &mut accelerations);
            }
        }
    });
    // a constant, so that sizes that do not fit are told at the path
    let function = quote_spanned! { path.span() =>
        const FUNCTION: fn(&[#t; SIZE], &[[#t; 3]; #connections], &mut [#t; ACCELERATIONS]) -> bool = #path;
    };
    Some(quote! {
        fn straight_rates(
            &self,
            time: #t,
            state: &Self::State,
            increment: &Self::Increment,
        ) -> ::core::option::Option<Self::Increment> {
            const SIZE: usize = #state::SIZE;
            // of 13 + 2 M numbers of each body, 6 + M
            const ACCELERATIONS: usize = (SIZE - #body_count) / 2;
            #function
            if let ::ffrf::mechanism::Treatment::Baumgarte { .. } = self.treatment {
                return ::core::option::Option::None;
            }
            let mut numbers: [#t; SIZE] = [0.0; SIZE];
            let mut places = numbers.iter_mut();
            #(#put)*
            let mut drives: [[#t; 3]; #connections] = [[0.0; 3]; #connections];
            #(#driven)*
            let mut accelerations: [#t; ACCELERATIONS] = [0.0; ACCELERATIONS];
            if !FUNCTION(&numbers, &drives, &mut accelerations) {
                return ::core::option::Option::None;
            }
            let mut accelerations = accelerations.iter().copied();
            let mut rates = *increment;
            #(#rates)*
            ::core::option::Option::Some(rates)
        }
    })
}
