//! The model: bodies, drives and forces to change, joints and markers that stay.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::spanned::Spanned as _;

use super::{Names, field_type, forces, markers_of, modal};
use crate::mechanism::bodies::{Body, Nature, UsedMarker};
use crate::mechanism::call::{Range, each, each_type};
use crate::mechanism::scalar::Scalar;
use crate::mechanism::spec::Spec;
use crate::parse::Input;

/// The struct and what makes it.
pub(super) fn model(input: &Input, names: &Names, spec: &Spec) -> TokenStream {
    let Input { attributes, visibility, .. } = input;
    let (name, state) = (&names.model, &names.state);
    let (declared, bound, used, t) =
        (spec.scalar.declared(), spec.scalar.bound(), spec.scalar.used(), spec.scalar.name());
    let count = spec.connections;
    let bodies = spec.bodies.iter().map(|body| {
        let (field, doc) = (&body.name, format!("Body `{}`.", body.name));
        let kind = field_type(body, &body.kind(&spec.scalar));
        quote! { #[doc = #doc] pub #field: #kind, }
    });
    let drives = spec.drives.iter().map(|drive| {
        let field = &drive.name;
        let doc = format!("Drive of joint `{}`.", spec.joints[drive.of.joint].name);
        let kind = each_type(drive.range.as_ref(), quote! { ::ffrf::mechanism::Drive<#t> });
        quote! { #[doc = #doc] pub #field: #kind, }
    });
    let forces = forces::fields(names, spec);
    let controls = spec.controls.iter().map(|control| {
        let (field, doc) =
            (&control.name, format!("Control `{}`, for forces of the user's own.", control.name));
        quote! { #[doc = #doc] pub #field: #t, }
    });
    let markers = spec.bodies.iter().map(|body| {
        let (field, modal, count) = (markers_of(body), modal(body, spec), body.markers.len());
        quote! { #field: [::ffrf::Marker<#modal, #t>; #count], }
    });
    let joint_names = joint_names(spec);
    let body_names: Vec<String> = spec.bodies.iter().flat_map(Body::names).collect();
    let body_count = body_names.len();
    let given: Vec<&Body> =
        spec.bodies.iter().filter(|body| !matches!(body.nature, Nature::Inline(_))).collect();
    let parameters = given.iter().map(|body| {
        let (field, kind) = (&body.name, field_type(body, &body.kind(&spec.scalar)));
        quote! { #field: #kind }
    });
    let values = values(spec);
    let checks = spec.bodies.iter().filter_map(|body| no_modes(body, spec.scalar));
    let resting = spec.bodies.iter().map(|body| {
        let field = &body.name;
        let one = quote! { ::ffrf::State::at_rest };
        match body.count {
            Some(_) => quote! { #field: self.#field.each_ref().map(|body| #one(body)) },
            None => quote! { #field: #one(&self.#field) },
        }
    });
    let size = size(names, spec.scalar);
    let restored = spec.bodies.iter().map(|body| {
        let each = super::slice_mut(body, &quote! { state });
        quote! { for body in #each { body.set_numbers(&mut numbers); } }
    });
    quote! {
        #(#attributes)*
        #[derive(Debug, Clone, Copy)]
        #visibility struct #name #declared {
            #(#bodies)*
            /// Gravity. Shape: 3. Units: m/s². Frame: inertial.
            pub gravity: ::ffrf::nalgebra::Vector3<#t>,
            #(#controls)*
            #(#drives)*
            #forces
            /// How joints are kept while time advances.
            pub treatment: ::ffrf::mechanism::Treatment<#t>,
            /// How redundant rows are dealt with.
            pub regularisation: ::ffrf::mechanism::Regularisation<#t>,
            connections: [::ffrf::mechanism::Connection<#t>; #count],
            #(#markers)*
        }

        #(#checks)*

        #[allow(dead_code, unused_variables, clippy::all, clippy::pedantic)]
        impl #bound #name #used {
            /// The joints and drives by their numbers in errors.
            pub const JOINTS: [&'static str; #count] = [#(#joint_names),*];

            /// The bodies by their numbers in errors.
            pub const BODIES: [&'static str; #body_count] = [#(#body_names),*];

            /// The mechanism of these bodies.
            pub fn new(#(#parameters),*) -> Self {
                #values
            }

            /// Every body at rest at the inertial origin, undeformed, its frame parallel to the inertial frame.
            pub fn at_rest(&self) -> #state #used {
                #state { #(#resting),* }
            }

            /// The same mechanism with second triads turned so that the orientations of `state` meet the joints.
            ///
            /// Without this, the triads of both ends of a joint are turned in their markers as the axes say.
            #[must_use]
            pub fn met_in(self, state: &#state #used) -> Self {
                let connections = {
                    let mut rooms = ::ffrf::mechanism::Assembly::<#t>::rooms(&self);
                    let ports =
                        ::ffrf::mechanism::Assembly::<#t>::ports(&self, &mut rooms, *state, ::core::option::Option::None);
                    self.connections.map(|connection| connection.met_in(&ports))
                };
                Self { connections, ..self }
            }

            /// The mechanism in motion: in `state`, at time zero.
            pub fn in_motion(self, state: #state #used) -> ::ffrf::mechanism::Mechanism<Self, #t> {
                ::ffrf::mechanism::Mechanism::new(self, state)
            }

            /// The state that was saved with `to_array`, bit by bit.
            pub fn state_from_array(&self, numbers: &[#t; #size]) -> #state #used {
                let mut state = self.at_rest();
                let mut numbers = numbers.iter().copied();
                #(#restored)*
                state
            }
        }
    }
}

/// How many numbers a state has, in double precision where it is generic.
pub(super) fn size(names: &Names, scalar: Scalar) -> TokenStream {
    let (state, in_double) = (&names.state, scalar.in_double());
    quote! { { #state #in_double::SIZE } }
}

/// Names of all connections in their order.
fn joint_names(spec: &Spec) -> Vec<String> {
    let mut names = Vec::with_capacity(spec.connections);
    for (index, joint) in spec.joints.iter().enumerate() {
        names.extend(joint.names());
        let drives = spec.drives.iter().filter(|drive| drive.of.joint == index);
        names.extend(drives.flat_map(|drive| drive.names()));
    }
    names
}

/// The body of `new`.
fn values(spec: &Spec) -> TokenStream {
    let (scalar, t, count) = (&spec.scalar, spec.scalar.name(), spec.connections);
    let bodies = spec.bodies.iter().map(|body| {
        let field = &body.name;
        match &body.nature {
            Nature::Inline(inline) => {
                let value = inline.expression(scalar);
                match body.count {
                    Some(count) => quote! { #field: [#value; #count] },
                    None => quote! { #field: #value },
                }
            }
            _ => quote! { #field },
        }
    });
    let markers = spec.bodies.iter().map(|body| {
        let field = markers_of(body);
        let markers = body.markers.iter().map(|marker| marker_value(body, marker, spec));
        quote! { #field: [#(#markers),*] }
    });
    let connected = spec.joints.iter().enumerate().map(|(index, joint)| {
        let [one, other] = joint.axes.orientations(scalar);
        let first = joint.ends[0].attachment(&spec.bodies, scalar, &one);
        let second = joint.ends[1].attachment(&spec.bodies, scalar, &other);
        let (start, number, kind) = (joint.first, joint.len(), &joint.kind);
        let index_of = joint.range.as_ref().map(Range::bind);
        let drives = spec.drives.iter().filter(|drive| drive.of.joint == index).map(|drive| {
            let (start, count) = (drive.first, drive.len());
            let kind = syn::Ident::new(drive.type_name, drive.name.span());
            let [first, second] = drive.of.attachments(&spec.joints, &spec.bodies, scalar);
            let bind = drive.range.as_ref().map(Range::bind);
            let number = if drive.range.is_some() { quote!(number) } else { quote!(_) };
            quote! {
                support::connect::<#t>(&mut connections, #start, #count, |#number| {
                    #bind
                    ::ffrf::mechanism::Connection {
                        kind: ::ffrf::joints::JointKind::#kind(::ffrf::joints::#kind),
                        first: #first,
                        second: #second,
                    }
                });
            }
        });
        let number_of = if joint.range.is_some() { quote!(number) } else { quote!(_) };
        quote! {
            support::connect::<#t>(&mut connections, #start, #number, |#number_of| {
                #index_of
                ::ffrf::mechanism::Connection { kind: #kind, first: #first, second: #second }
            });
            #(#drives)*
        }
    });
    let drives = spec.drives.iter().map(|drive| {
        let (field, function) = (&drive.name, &drive.function);
        let value = each(drive.range.as_ref(), function.clone());
        quote! { #field: #value }
    });
    let forces = forces::values(spec);
    let controls = spec.controls.iter().map(|control| {
        let (field, value) = (&control.name, &control.value);
        quote! { #field: #value }
    });
    let treatment = &spec.treatment;
    let gravity = scalar.vector(&spec.gravity);
    let regularisation = if spec.has_loops { quote!(of_loops) } else { quote!(of_trees) };
    quote! {
        use ::ffrf::generated_support::mechanism as support;
        let mut connections = [support::unconnected::<#t>(); #count];
        #(#connected)*
        Self {
            #(#bodies,)*
            gravity: #gravity,
            #(#controls,)*
            #(#drives,)*
            #(#forces,)*
            treatment: #treatment,
            regularisation: ::ffrf::mechanism::Regularisation::#regularisation(),
            connections,
            #(#markers,)*
        }
    }
}

fn marker_value(body: &Body, marker: &UsedMarker, spec: &Spec) -> TokenStream {
    let (kind, t) = (body.kind(&spec.scalar), spec.scalar.name());
    match marker {
        UsedMarker::Constant(name) if spec.scalar == Scalar::Generic => quote! { #kind::#name.cast::<#t>() },
        UsedMarker::Constant(name) => quote! { #kind::#name },
        UsedMarker::Point(position) => {
            let (field, position) = (&body.name, spec.scalar.vector(position));
            let alike = match (&body.nature, body.count) {
                (Nature::Inline(_), _) => quote! { &::ffrf::nalgebra::SVector::<#t, 0>::zeros() },
                (_, Some(_)) => quote! {
                    &::ffrf::FlexibleBody::<#t>::undeformed(support::first(&#field))
                },
                (_, None) => quote! { &::ffrf::FlexibleBody::<#t>::undeformed(&#field) },
            };
            quote! { ::ffrf::Marker::rigid(#position, #alike) }
        }
    }
}

/// Bodies that are said to be rigid have no modes: checked while compiling.
fn no_modes(body: &Body, scalar: Scalar) -> Option<TokenStream> {
    let Nature::Rigid(kind) = &body.nature else { return None };
    let t = scalar.of_constants();
    let message = format!("body `{}` is said to be rigid, but its type has modes", body.name);
    Some(quote_spanned! { kind.span() =>
        const _: () = ::core::assert!(
            ::core::mem::size_of::<<#kind as ::ffrf::FlexibleBody<#t>>::Modal>() == 0,
            #message
        );
    })
}
