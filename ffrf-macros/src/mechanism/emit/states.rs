//! The states of all bodies, changes of them, and the bodies in one state.

use proc_macro2::TokenStream;
use quote::quote;

use super::rooms::room_parameters;
use super::{Names, field_type, modal, slice, slice_mut};
use crate::mechanism::spec::Spec;
use crate::parse::Input;

/// State, increment and ports.
pub(super) fn states(input: &Input, names: &Names, spec: &Spec) -> TokenStream {
    let visibility = &input.visibility;
    let (state, increment, ports) = (&names.state, &names.increment, &names.ports);
    let (declared, bound, used, t) =
        (spec.scalar.declared(), spec.scalar.bound(), spec.scalar.used(), spec.scalar.name());
    let fields = |make: &dyn Fn(&TokenStream) -> TokenStream| {
        let fields = spec.bodies.iter().map(|body| {
            let (field, doc) = (&body.name, format!("Of body `{}`.", body.name));
            let kind = field_type(body, &make(&modal(body, spec)));
            quote! { #[doc = #doc] pub #field: #kind, }
        });
        quote! { #(#fields)* }
    };
    let state_fields = fields(&|modal| quote! { ::ffrf::State<#modal, #t> });
    let increment_fields = fields(&|modal| quote! { ::ffrf::Increment<#modal, #t> });
    let port_fields = spec.bodies.iter().map(|body| {
        let (field, doc) = (&body.name, format!("Body `{}`.", body.name));
        let (kind, [rows, kept]) = (body.kind(&spec.scalar), room_parameters(body, spec));
        let kind = field_type(body, &quote! { ::ffrf::mechanism::BodyPort<'a, #kind, #rows, #t, #kept> });
        quote! { #[doc = #doc] pub #field: #kind, }
    });
    let port_parameters = match spec.scalar {
        crate::mechanism::scalar::Scalar::Generic => {
            quote! { <'a, T: ::ffrf::generated_support::Number = f64> }
        }
        _ => quote! { <'a> },
    };
    let in_double = spec.scalar.in_double();
    let double = spec.scalar.of_constants();
    let saved = spec.bodies.iter().map(|body| {
        let each = slice(body, &quote! { self });
        quote! {
            for body in #each {
                for number in body.numbers() {
                    if let ::core::option::Option::Some(place) = places.next() {
                        *place = number;
                    }
                }
            }
        }
    });
    let add = spec.bodies.iter().map(|body| {
        let (own, other) = (slice_mut(body, &quote! { self }), slice(body, &quote! { other }));
        quote! { for (own, other) in #own.iter_mut().zip(#other) { own.add_scaled(factor, other); } }
    });
    let scale = spec.bodies.iter().map(|body| {
        let own = slice_mut(body, &quote! { self });
        quote! { for own in #own { own.scale(factor); } }
    });
    let dot = spec.bodies.iter().map(|body| {
        let (own, other) = (slice(body, &quote! { self }), slice(body, &quote! { other }));
        quote! { for (own, other) in #own.iter().zip(#other) { sum += own.dot(other); } }
    });
    let size = super::model::size(names, spec.scalar);
    quote! {
        /// The state of each body.
        #[derive(Debug, Clone, Copy, PartialEq)]
        #visibility struct #state #declared {
            #state_fields
        }

        #[allow(dead_code, clippy::all, clippy::pedantic)]
        impl #bound #state #used {
            /// Number of its numbers: 13 and twice the modes of each body.
            pub const SIZE: usize =
                ::core::mem::size_of::<#state #in_double>() / ::core::mem::size_of::<#double>();

            /// Every number of the state, to be saved: body by body as `ffrf::State::numbers` has them.
            pub fn to_array(&self) -> [#t; #size] {
                let mut numbers = [::ffrf::generated_support::constant::<#t>(0.0); #size];
                let mut places = numbers.iter_mut();
                #(#saved)*
                numbers
            }
        }

        /// A change of the state of each body.
        #[derive(Debug, Clone, Copy, PartialEq)]
        #visibility struct #increment #declared {
            #increment_fields
        }

        /// Each body in one state, with its forces and the rows of its joints.
        #visibility struct #ports #port_parameters {
            #(#port_fields)*
        }

        #[allow(clippy::all, clippy::pedantic)]
        impl #bound ::ffrf::VectorSpace<#t> for #increment #used {
            fn add_scaled(&mut self, factor: #t, other: &Self) {
                #(#add)*
            }

            fn scale(&mut self, factor: #t) {
                #(#scale)*
            }

            fn dot(&self, other: &Self) -> #t {
                let mut sum = ::ffrf::generated_support::constant::<#t>(0.0);
                #(#dot)*
                sum
            }
        }
    }
}
