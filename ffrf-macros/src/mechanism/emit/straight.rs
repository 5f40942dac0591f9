//! Accelerations by functions that were printed for the mechanism: their arguments, and what their results are to integrators.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::Path;
use syn::spanned::Spanned as _;

use super::{Names, slice, slice_mut};
use crate::mechanism::bodies::Body;
use crate::mechanism::spec::Spec;

/// `Assembly::straight_rates`, `straight_implicit_rates` and `straight_projection`, as far as the mechanism has such functions.
pub(super) fn straight_rates(names: &Names, spec: &Spec) -> TokenStream {
    let explicit = spec.accelerations.as_ref().map(|path| explicit(names, spec, path));
    let implicit = spec.implicit_accelerations.as_ref().map(|path| implicit(names, spec, path));
    let projection = projection(names, spec);
    quote! { #explicit #implicit #projection }
}

fn explicit(names: &Names, spec: &Spec, path: &Path) -> TokenStream {
    let (t, connections) = (spec.scalar.name(), spec.connections);
    let (sizes, arguments, [count, accelerations]) = (sizes(names), arguments(spec), accelerations(spec));
    let rates = results(spec, |body| {
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
    quote! {
        fn straight_rates(
            &self,
            time: #t,
            state: &Self::State,
            increment: &Self::Increment,
        ) -> ::core::option::Option<Self::Increment> {
            #sizes
            #count
            #function
            #arguments
            #accelerations
            if !FUNCTION(&numbers, &drives, &mut accelerations) {
                return ::core::option::Option::None;
            }
            #rates
        }
    }
}

fn implicit(names: &Names, spec: &Spec, path: &Path) -> TokenStream {
    let (t, connections) = (spec.scalar.name(), spec.connections);
    let (sizes, arguments, [count, accelerations]) = (sizes(names), arguments(spec), accelerations(spec));
    let body_count = body_count(spec);
    let less = spec.bodies.iter().map(|body| {
        let (less, charts) = (slice(body, &quote! { all }), slice(body, &quote! { increment }));
        quote! {
            for (subtracted, increment) in #less.iter().zip(#charts) {
                support::put_subtracted(subtracted, increment, &mut places);
            }
        }
    });
    let follow = spec.soft.is_some();
    let rates = results(spec, |body| {
        let (own, states) = (slice_mut(body, &quote! { rates }), slice(body, &quote! { state }));
        let less = slice(body, &quote! { all });
        quote! {
            let mut less = subtracted.map(|all| #less.iter());
            for (own, state) in #own.iter_mut().zip(#states) {
                let less = less.as_mut().and_then(::core::iter::Iterator::next);
                *own = support::implicit_rate_with(own, state, &mut accelerations, gamma_h, less, #follow);
            }
        }
    });
    let function = quote_spanned! { path.span() =>
        const FUNCTION: fn(
            &[#t; SIZE],
            &[#t; SUBTRACTED],
            #t,
            &[[#t; 3]; #connections],
            &mut [#t; ACCELERATIONS],
        ) -> bool = #path;
    };
    quote! {
        fn straight_implicit_rates(
            &self,
            time: #t,
            state: &Self::State,
            increment: &Self::Increment,
            gamma_h: #t,
            subtracted: ::core::option::Option<&Self::Increment>,
        ) -> ::core::option::Option<Self::Increment> {
            #sizes
            #count
            // of each body one number less
            const SUBTRACTED: usize = SIZE - #body_count;
            #function
            #arguments
            #accelerations
            let mut less: [#t; SUBTRACTED] = [0.0; SUBTRACTED];
            if let ::core::option::Option::Some(all) = subtracted {
                let mut places = less.iter_mut();
                #(#less)*
            }
            if !FUNCTION(&numbers, &less, gamma_h, &drives, &mut accelerations) {
                return ::core::option::Option::None;
            }
            #rates
        }
    }
}

fn projection(names: &Names, spec: &Spec) -> Option<TokenStream> {
    if spec.projection.is_none() && spec.implicit_projection.is_none() {
        return None;
    }
    let (t, connections, rows) = (spec.scalar.name(), spec.connections, spec.rows);
    let (sizes, arguments) = (sizes(names), arguments(spec));
    let take = spec.bodies.iter().map(|body| {
        let states = slice_mut(body, &quote! { projected });
        quote! {
            for state in #states.iter_mut() {
                support::measure(state, &mut sizes);
                support::take_state(state, &mut places);
            }
        }
    });
    let explicit = spec.projection.as_ref().map(|path| {
        quote_spanned! { path.span() =>
            const FUNCTION: fn(&[#t; SIZE], &[[#t; 3]; #connections], &mut [#t; SIZE + 4 * #rows]) -> bool = #path;
        }
    });
    let implicit = spec.implicit_projection.as_ref().map(|path| {
        quote_spanned! { path.span() =>
            const IMPLICIT: fn(&[#t; SIZE], #t, &[[#t; 3]; #connections], &mut [#t; SIZE + 4 * #rows]) -> bool =
                #path;
        }
    });
    let none = quote! { return ::core::option::Option::None };
    let explicitly = if explicit.is_some() {
        quote! { FUNCTION(&numbers, &drives, &mut found) }
    } else {
        none.clone()
    };
    let implicitly = if implicit.is_some() {
        quote! { IMPLICIT(&numbers, gamma_h, &drives, &mut found) }
    } else {
        none
    };
    let gamma_h = if implicit.is_some() {
        quote! { gamma_h }
    } else {
        quote! { _ }
    };
    Some(quote! {
        fn straight_projection(
            &self,
            time: #t,
            state: &Self::State,
            gamma_h: ::core::option::Option<#t>,
        ) -> ::core::option::Option<::ffrf::mechanism::Projected<Self::State, #t>> {
            #sizes
            #explicit
            #implicit
            #arguments
            let mut found: [#t; SIZE + 4 * #rows] = [0.0; SIZE + 4 * #rows];
            let holds = match gamma_h {
                ::core::option::Option::None => #explicitly,
                ::core::option::Option::Some(#gamma_h) => #implicitly,
            };
            if !holds {
                return ::core::option::Option::None;
            }
            let (places, residuals) = found.split_at(SIZE);
            let mut places = places.iter().copied();
            let (mut projected, mut sizes) = (*state, [0.0; 2]);
            #(#take)*
            let [before, after] = support::largest_residuals(residuals);
            ::core::option::Option::Some(::ffrf::mechanism::Projected { state: projected, before, after, sizes })
        }
    })
}

fn body_count(spec: &Spec) -> usize {
    spec.bodies.iter().map(Body::len).sum()
}

/// How many numbers a state has.
fn sizes(names: &Names) -> TokenStream {
    let state = &names.state;
    quote! {
        const SIZE: usize = #state::SIZE;
    }
}

/// `numbers` of the state, `drives`, and a place for `accelerations`.
fn arguments(spec: &Spec) -> TokenStream {
    let (t, connections) = (spec.scalar.name(), spec.connections);
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
    quote! {
        if let ::ffrf::mechanism::Treatment::Baumgarte { .. } = self.treatment {
            return ::core::option::Option::None;
        }
        let mut numbers: [#t; SIZE] = [0.0; SIZE];
        let mut places = numbers.iter_mut();
        #(#put)*
        let mut drives: [[#t; 3]; #connections] = [[0.0; 3]; #connections];
        #(#driven)*
    }
}

/// How many accelerations there are, and a place for them.
fn accelerations(spec: &Spec) -> [TokenStream; 2] {
    let (t, body_count) = (spec.scalar.name(), body_count(spec));
    let count = quote! {
        // of 13 + 2 M numbers of each body, 6 + M
        const ACCELERATIONS: usize = (SIZE - #body_count) / 2;
    };
    [count, quote! { let mut accelerations: [#t; ACCELERATIONS] = [0.0; ACCELERATIONS]; }]
}

/// The rates of all bodies from the accelerations, those of each by `rates`.
fn results(spec: &Spec, rates: impl Fn(&Body) -> TokenStream) -> TokenStream {
    let rates = spec.bodies.iter().map(rates);
    quote! {
        let mut accelerations = accelerations.iter().copied();
        let mut rates = *increment;
        #(#rates)*
        ::core::option::Option::Some(rates)
    }
}
