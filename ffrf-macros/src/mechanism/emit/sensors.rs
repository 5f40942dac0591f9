//! Sensors as methods of the model.

use proc_macro2::TokenStream;
use quote::quote;

use super::Names;
use crate::mechanism::call::{each, each_type};
use crate::mechanism::sensors::Measured;
use crate::mechanism::spec::Spec;

/// A method for each sensor.
pub(super) fn sensors(names: &Names, spec: &Spec) -> TokenStream {
    if spec.sensors.is_empty() {
        return TokenStream::new();
    }
    let (name, state) = (&names.model, &names.state);
    let (bound, used, t) = (spec.scalar.bound(), spec.scalar.used(), spec.scalar.name());
    let vector = quote! { ::ffrf::nalgebra::Vector3<#t> };
    let ports = quote! {
        let mut rooms = ::ffrf::mechanism::Assembly::<#t>::rooms(self);
        let ports =
            ::ffrf::mechanism::Assembly::<#t>::ports(self, &mut rooms, *state, ::core::option::Option::None);
    };
    let evaluated = |value: TokenStream, result: &TokenStream| {
        quote! {
            -> ::core::result::Result<#result, ::ffrf::StepError> {
                ::ffrf::mechanism::Constrained(self).evaluate(
                    time,
                    *state,
                    ::core::option::Option::None,
                    |ports, storage| #value,
                )
            }
        }
    };
    let methods = spec.sensors.iter().map(|sensor| {
        let (method, range) = (&sensor.name, sensor.range.as_ref());
        match &sensor.measured {
            Measured::Motion { field, at } => {
                let (doc, result) = match field.to_string().as_str() {
                    "position" => ("Position. Shape: 3. Units: m. Frame: inertial.", vector.clone()),
                    "velocity" => ("Velocity. Shape: 3. Units: m/s. Frame: inertial.", vector.clone()),
                    _ => (
                        "Orientation: maps components in the marker's triad to inertial components.",
                        quote! { ::ffrf::nalgebra::UnitQuaternion<#t> },
                    ),
                };
                let (result, value) = (each_type(range, result), each(range, quote! { #at.motion(&ports).#field }));
                quote! {
                    #[doc = #doc]
                    pub fn #method(&self, state: &#state #used) -> #result {
                        #ports
                        #value
                    }
                }
            }
            Measured::Angle { connections } => {
                let angles = connections.iter().map(|connection| {
                    quote! {
                        ::ffrf::forces::relative_angle(
                            &self.connections[#connection].first.motion(&ports),
                            &self.connections[#connection].second.motion(&ports),
                        )
                    }
                });
                let value = if range.is_some() { quote! { [#(#angles),*] } } else { quote! { #(#angles)* } };
                let result = each_type(range, quote! { #t });
                quote! {
                    /// Angle of the joint about its axis, within half a turn. Units: rad.
                    pub fn #method(&self, state: &#state #used) -> #result {
                        #ports
                        #value
                    }
                }
            }
            Measured::Acceleration { at } => {
                let value = each(range, quote! { ::ffrf::mechanism::acceleration(&#at, ports) });
                let body = evaluated(
                    quote! {{
                        let _ = storage;
                        #value
                    }},
                    &each_type(range, vector.clone()),
                );
                quote! {
                    /// Acceleration at `time` (s). Shape: 3. Units: m/s². Frame: inertial.
                    ///
                    /// Errors: no accelerations exist in this state.
                    pub fn #method(&self, time: #t, state: &#state #used) #body
                }
            }
            Measured::Reaction { field, connections } => {
                let doc = match *field {
                    "force" => "Force of the joint on its second body at `time` (s). Shape: 3. Units: N. Frame: inertial.",
                    _ => "Moment of the joint on its second body, about the marker there, at `time` (s). Shape: 3. Units: N m. Frame: inertial.",
                };
                let field = syn::Ident::new(field, method.span());
                let sums = connections.iter().map(|own| {
                    let terms = own.iter().map(|connection| {
                        quote! { ::ffrf::mechanism::reaction(&plan, storage, #connection).#field }
                    });
                    quote! { #(#terms)+* }
                });
                let value = if range.is_some() { quote! { [#(#sums),*] } } else { quote! { #(#sums)* } };
                let body = evaluated(
                    quote! {{
                        let _ = ports;
                        let plan = ::ffrf::mechanism::Assembly::<#t>::plan(self);
                        #value
                    }},
                    &each_type(range, vector.clone()),
                );
                quote! {
                    #[doc = #doc]
                    ///
                    /// Errors: no accelerations exist in this state.
                    pub fn #method(&self, time: #t, state: &#state #used) #body
                }
            }
        }
    });
    quote! {
        #[allow(dead_code, unused_variables, clippy::all, clippy::pedantic)]
        impl #bound #name #used {
            #(#methods)*
        }
    }
}
