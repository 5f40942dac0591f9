//! What integrators need of a mechanism: the implementation of `Assembly`.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::branches::{Branches, branches};
use super::forces::{forces, friction_count};
use super::plan::{Layout, hubs, layout};
use super::rooms::rooms;
use super::straight::straight_rates;
use super::{Names, hubs_of, markers_of, slice, slice_mut};
use crate::mechanism::bodies::Body;
use crate::mechanism::scalar::Scalar;
use crate::mechanism::spec::Spec;

/// The implementations of `Ports` and `Assembly`, with the constants of the plan.
pub(super) fn assembly(names: &Names, spec: &Spec) -> TokenStream {
    let Names { model, state, increment, ports } = names;
    let (bound, used, t) = (spec.scalar.bound(), spec.scalar.used(), spec.scalar.name());
    let hard = layout(&spec.plan, "");
    let mut constants = hubs(spec);
    constants.extend(hard.constants.clone());
    let tree = branches(spec);
    constants.extend(tree.iter().map(|tree| tree.constants.clone()));
    let soft_storage = spec.soft.as_ref().map(|(soft, links)| {
        let soft = layout(soft, "SOFT_");
        let (of_soft, expression) = (&soft.constants, &soft.plan);
        constants.extend(quote! {
            #of_soft
            fn soft_plan() -> places::Plan<'static> {
                #expression
            }
        });
        storage(spec, &soft, *links, None)
    });
    let only_hard = storage(spec, &hard, 0, None);
    let of_rows = &hard.plan;
    let plan_expression = match &tree {
        None => of_rows.clone(),
        Some(Branches { list, .. }) => quote! { places::Plan { branches: #list, ..#of_rows } },
    };
    let soft_storage = soft_storage.map(|storage| quote! { places::Equations::SoftRows => #storage, });
    let of_tree = tree.as_ref().map(|tree| {
        let storage = storage(spec, &hard, 0, Some(tree));
        quote! { places::Equations::Tree => #storage, }
    });
    let storage = quote! {
        match equations {
            #soft_storage
            #of_tree
            _ => #only_hard,
        }
    };
    let of_ports = ports_of(ports, spec);
    let lifetime_and_type = match spec.scalar {
        Scalar::Generic => quote! { <'a, T> },
        _ => quote! { <'a> },
    };
    let made = spec.bodies.iter().enumerate().map(|(place, body)| port(body, place, spec));
    let [rooms, absent_rooms] = rooms(spec);
    let each = |owner: &str, action: TokenStream| {
        let owner: TokenStream = syn::Ident::new(owner, proc_macro2::Span::call_site()).into_token_stream();
        let loops = spec.bodies.iter().map(move |body| {
            let items = slice_mut(body, &owner);
            (items, body)
        });
        let loops = loops.map(|(items, _)| quote! { for port in #items { #action } });
        quote! { #(#loops)* }
    };
    let pairs = |own: &str, other: &str, action: TokenStream, changes: bool| {
        let (own, other) = (ident(own), ident(other));
        let loops = spec.bodies.iter().map(|body| {
            let (read, other) = (slice(body, &own), slice(body, &other));
            let own = slice_mut(body, &own);
            let own = if changes {
                quote! { #own.iter_mut() }
            } else {
                quote! { #read.iter() }
            };
            quote! { for (own, other) in #own.zip(#other) { #action } }
        });
        quote! { #(#loops)* }
    };
    let collect = pairs("rates", "ports", quote! { *own = other.rate(own); }, true);
    let correct = each("ports", quote! { port.correct(level); });
    let kept = spec.bodies.iter().map(|body| {
        let field = &body.name;
        match body.count {
            Some(_) => quote! { #field: ports.#field.map(|port| port.state) },
            None => quote! { #field: ports.#field.state },
        }
    });
    let weigh = each("ports", quote! { ::ffrf::mechanism::Port::weigh(port, &self.gravity); });
    let forces = forces(spec);
    let (applied, friction, soft, stored) = (&forces.applied, &forces.friction, &forces.soft, &forces.stored);
    let energies = pairs("self", "state", quote! { sum.add_body(own, other, &self.gravity); }, false);
    let momenta = pairs("self", "state", quote! { sum.add_body(own, other); }, false);
    let driven = spec.drives.iter().map(|drive| {
        let (field, connection) = (&drive.name, drive.first);
        match &drive.range {
            None => quote! { #connection => self.#field.at(time), },
            Some(_) => {
                let last = connection + drive.len() - 1;
                quote! {
                    #connection..=#last => self.#field.get(joint - #connection).map_or(none, |drive| drive.at(time)),
                }
            }
        }
    });
    let finite = spec.bodies.iter().map(|body| {
        let items = slice(body, &ident("state"));
        quote! { #items.iter().all(::ffrf::State::is_finite) }
    });
    let none = spec.bodies.iter().map(|body| {
        let field = &body.name;
        let one = quote! { ::ffrf::Increment::zeros };
        match body.count {
            Some(_) => quote! { #field: state.#field.map(|state| #one(&state.modal_coordinates)) },
            None => quote! { #field: #one(&state.#field.modal_coordinates) },
        }
    });
    let retract = pairs("state", "increment", quote! { *own = own.retract(other); }, true);
    let place = pairs("rates", "origin", quote! { *own = own.place_rate(&other.retract(own)); }, true);
    let velocities = each("increment", quote! { *port = port.velocities_only(); });
    let local = spec.bodies.iter().map(|body| {
        let items = slice(body, &ident("difference"));
        quote! { for part in #items { error = error.or(part.local_error()); } }
    });
    let weighted = spec.bodies.iter().map(|body| {
        let (states, parts) = (slice(body, &ident("state")), slice(body, &ident("difference")));
        quote! {
            for (state, part) in #states.iter().zip(#parts) {
                let (squares, number) = part.weighted_squares(state, tolerances);
                sum += squares;
                count += number;
            }
        }
    });
    let stable = spec.bodies.iter().map(|body| {
        let items = slice(body, &ident("self"));
        quote! {
            for body in #items {
                if let ::core::option::Option::Some(step) = ::ffrf::FlexibleBody::<#t>::largest_stable_step(body) {
                    least = ::core::option::Option::Some(match least {
                        ::core::option::Option::Some(other) if other < step => other,
                        _ => step,
                    });
                }
            }
        }
    });
    let zero = quote! { ::ffrf::generated_support::constant::<#t>(0.0) };
    let straight = straight_rates(names, spec);
    quote! {
        #[allow(
            clippy::all,
            clippy::pedantic,
            clippy::nursery,
            unused_imports,
            unused_qualifications,
            unused_variables,
            unused_mut
        )]
        const _: () = {
            // by its path: a mechanism may have any of these names
            use ::ffrf::mechanism as places;
            #constants
            use ::ffrf::generated_support::mechanism as support;

            #of_ports

            impl #bound ::ffrf::mechanism::Assembly<#t> for #model #used {
                type State = #state #used;
                type Increment = #increment #used;
                type Modes = ();
                type Ports<'a> = #ports #lifetime_and_type where Self: 'a;

                type Rooms = #rooms;

                fn rooms(&self) -> Self::Rooms {
                    #absent_rooms
                }

                fn ports<'a>(
                    &'a self,
                    rooms: &'a mut Self::Rooms,
                    state: Self::State,
                    implicit: ::core::option::Option<::ffrf::mechanism::ImplicitTerms<'a, Self::Increment, #t>>,
                ) -> Self::Ports<'a> {
                    #ports { #(#made),* }
                }

                fn collect(&self, ports: &Self::Ports<'_>, increment: &Self::Increment) -> Self::Increment {
                    let mut rates = *increment;
                    #collect
                    rates
                }

                #straight

                fn correct(&self, ports: &mut Self::Ports<'_>, level: ::ffrf::mechanism::Level) {
                    #correct
                }

                fn state(&self, ports: Self::Ports<'_>) -> Self::State {
                    #state { #(#kept),* }
                }

                fn with_storage<R>(
                    &self,
                    equations: ::ffrf::mechanism::Equations,
                    use_it: impl FnOnce(&mut ::ffrf::mechanism::Storage<'_, #t>) -> R,
                ) -> R {
                    #storage
                }

                fn plan(&self) -> ::ffrf::mechanism::Plan<'_> {
                    #plan_expression
                }

                fn connections(&self) -> &[::ffrf::mechanism::Connection<#t>] {
                    &self.connections
                }

                fn joint_name(&self, joint: usize) -> &'static str {
                    match Self::JOINTS.get(joint) {
                        ::core::option::Option::Some(name) => name,
                        ::core::option::Option::None => "",
                    }
                }

                fn drive(&self, joint: usize, time: #t) -> [#t; 3] {
                    let none = [#zero; 3];
                    match joint {
                        #(#driven)*
                        _ => none,
                    }
                }

                fn load(&self, time: #t, ports: &mut Self::Ports<'_>) {
                    #weigh
                    #applied
                }

                #friction

                #soft

                fn energy(&self, state: &Self::State) -> ::ffrf::mechanism::Energy<#t> {
                    let mut sum = ::ffrf::mechanism::Energy::none();
                    #energies
                    #stored
                    sum
                }

                fn momentum(&self, state: &Self::State) -> ::ffrf::mechanism::Momentum<#t> {
                    let mut sum = ::ffrf::mechanism::Momentum::none();
                    #momenta
                    sum
                }

                fn treatment(&self) -> ::ffrf::mechanism::Treatment<#t> {
                    self.treatment
                }

                fn regularisation(&self) -> ::ffrf::mechanism::Regularisation<#t> {
                    self.regularisation
                }

                fn is_finite(&self, state: &Self::State) -> bool {
                    #(#finite)&&*
                }

                fn no_change(&self, state: &Self::State) -> Self::Increment {
                    #increment { #(#none),* }
                }

                fn retract(&self, origin: &Self::State, increment: &Self::Increment) -> Self::State {
                    let mut state = *origin;
                    #retract
                    state
                }

                fn place_rates(&self, origin: &Self::State, increment: &Self::Increment) -> Self::Increment {
                    let mut rates = *increment;
                    #place
                    rates
                }

                fn velocities_only(&self, increment: &Self::Increment) -> Self::Increment {
                    let mut increment = *increment;
                    #velocities
                    increment
                }

                fn local_error(&self, difference: &Self::Increment) -> ::ffrf::LocalError<#t> {
                    let mut error = ::ffrf::LocalError {
                        position: #zero,
                        orientation: #zero,
                        modal_coordinates: #zero,
                    };
                    #(#local)*
                    error
                }

                fn weighted_error(
                    &self,
                    state: &Self::State,
                    difference: &Self::Increment,
                    tolerances: &::ffrf::Tolerances<#t>,
                ) -> #t {
                    let (mut sum, mut count) = (#zero, #zero);
                    #(#weighted)*
                    ::ffrf::nalgebra::ComplexField::sqrt(sum / count)
                }

                fn largest_stable_step(&self) -> ::core::option::Option<#t> {
                    let mut least: ::core::option::Option<#t> = ::core::option::Option::None;
                    #(#stable)*
                    least
                }
            }
        };
    }
}

/// The call of `use_it` with the numbers of a plan.
fn storage(spec: &Spec, layout: &Layout, links: usize, tree: Option<&Branches>) -> TokenStream {
    let t = spec.scalar.name();
    let zero = quote! { ::ffrf::generated_support::constant::<#t>(0.0) };
    let (blocks, nodes, frictions) = (&layout.blocks, &layout.nodes, friction_count(spec));
    let all = spec.connections + links;
    let (blocks, shifts, [limbs, freedoms]) = match tree {
        None => (blocks, nodes, &[quote! { 0 }, quote! { 0 }]),
        Some(tree) => (&quote! { 0 }, &quote! { 0 }, &tree.counts),
    };
    quote! {
        use_it(&mut ::ffrf::mechanism::Storage {
            blocks: &mut support::absent::<_, #blocks>(),
            solution: &mut [[#zero; 6]; #nodes],
            right: &mut [[#zero; 6]; #nodes],
            shift: &mut [[#zero; 6]; #shifts],
            efforts: &mut [#zero; #frictions],
            joints: &mut support::absent::<_, #all>(),
            soft_markers: &mut [[0; 2]; #links],
            limbs: &mut support::absent::<_, #limbs>(),
            freedoms: &mut support::absent::<_, #freedoms>(),
        })
    }
}

fn ident(name: &str) -> TokenStream {
    let ident = syn::Ident::new(name, proc_macro2::Span::call_site());
    quote! { #ident }
}

/// The ports of one body, or of an array of them.
fn port(body: &Body, place: usize, spec: &Spec) -> TokenStream {
    let room = syn::Index::from(place);
    let (field, markers, t) = (&body.name, markers_of(body), spec.scalar.name());
    let terms = |subtracted: TokenStream, chart: TokenStream| {
        quote! {
            implicit.map(|terms| ::ffrf::mechanism::ImplicitTerms {
                gamma_h: terms.gamma_h,
                subtracted: #subtracted,
                chart: #chart,
            })
        }
    };
    let hubs = hubs_of(body, spec);
    let kept = match body.count {
        _ if hubs.is_empty() => quote! { () },
        None => quote! { support::kept(&self.#field, KEEPS_MODES) },
        Some(_) => quote! { support::kept(body, KEEPS_MODES && [#(#hubs),*].contains(&number)) },
    };
    let number = (!hubs.is_empty()).then(|| quote! { let number = numbers.next().unwrap_or(0); });
    let numbers = (!hubs.is_empty()).then(|| quote! { let mut numbers = 0_usize..; });
    match body.count {
        None => {
            let of_body = |what: TokenStream| quote! { terms.#what.map(|all| &all.#field) };
            let terms = terms(of_body(quote! { subtracted }), of_body(quote! { chart }));
            quote! {
                #field: ::ffrf::mechanism::BodyPort::new(
                    &self.#field,
                    &self.#markers,
                    state.#field,
                    #terms,
                    (support::absent(), #kept),
                    &mut rooms.#room,
                )
            }
        }
        Some(_) => {
            let terms = terms(quote! { subtracted }, quote! { chart });
            quote! {
                #field: {
                    let mut states = state.#field.iter();
                    let all = implicit.and_then(|terms| terms.subtracted);
                    let mut changes = all.map(|all| all.#field.iter());
                    let all = implicit.and_then(|terms| terms.chart);
                    let mut charts = all.map(|all| all.#field.iter());
                    let mut bodies = self.#field.iter();
                    #numbers
                    rooms.#room.each_mut().map(|room| {
                        let body = bodies.next().unwrap_or(support::first(&self.#field));
                        #number
                        let subtracted = changes.as_mut().and_then(::core::iter::Iterator::next);
                        let chart = charts.as_mut().and_then(::core::iter::Iterator::next);
                        let state = states.next().copied();
                        ::ffrf::mechanism::BodyPort::new(
                            body,
                            &self.#markers,
                            state.unwrap_or_else(|| ::ffrf::State::<_, #t>::at_rest(body)),
                            #terms,
                            (support::absent(), #kept),
                            room,
                        )
                    })
                }
            }
        }
    }
}

/// Bodies by their numbers.
fn ports_of(ports: &syn::Ident, spec: &Spec) -> TokenStream {
    let (bound, t) = (spec.scalar.bound(), spec.scalar.name());
    let used = match spec.scalar {
        Scalar::Generic => quote! { <'_, T> },
        _ => quote! { <'_> },
    };
    let arms = |mutable: bool| -> TokenStream {
        let arms = spec.bodies.iter().map(|body| {
            let (field, first) = (&body.name, body.first);
            let last = first + body.len() - 1;
            let reference = if mutable { quote!(&mut) } else { quote!(&) };
            let get = if mutable { quote!(get_mut) } else { quote!(get) };
            match body.count {
                None => quote! { #first => ::core::option::Option::Some(#reference self.#field), },
                Some(_) => {
                    let kind = if mutable { quote!(&mut dyn ) } else { quote!(&dyn ) };
                    quote! {
                        #first..=#last => match self.#field.#get(index - #first) {
                            ::core::option::Option::Some(port) => {
                                ::core::option::Option::Some(port as #kind ::ffrf::mechanism::Port<#t>)
                            }
                            ::core::option::Option::None => ::core::option::Option::None,
                        },
                    }
                }
            }
        });
        quote! { match index { #(#arms)* _ => ::core::option::Option::None } }
    };
    let (read, write) = (arms(false), arms(true));
    quote! {
        impl #bound ::ffrf::mechanism::Ports<#t> for #ports #used {
            fn port(&self, index: usize) -> ::core::option::Option<&dyn ::ffrf::mechanism::Port<#t>> {
                #read
            }

            fn port_mut(&mut self, index: usize) -> ::core::option::Option<&mut dyn ::ffrf::mechanism::Port<#t>> {
                #write
            }
        }
    }
}
