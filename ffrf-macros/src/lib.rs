//! The macros `flexible_body!` and `mechanism!`: parse, validate, generate, report errors with their places.
#![forbid(unsafe_code)]

mod expand;
mod fallback;
mod family;
mod mechanism;
mod parse;
mod validate;
mod values;

use proc_macro::TokenStream;

/// Generates a flexible body from a model file, or for invariants that are supplied at run time.
///
/// ```text
/// ffrf::flexible_body! {
///     /// Rotor with disc.
///     pub struct Rotor {
///         model: "models/rotor.ffrf.json",   // relative to the folder of Cargo.toml
///         modes: ..8,                        // optional: the first 8 modes only, or 2..5, or [0, 2, 5] (from 0)
///         scalar: f64,                       // optional: f64 (default), f32 or generic
///         fidelity: full,                    // optional: rigid, constant, linear, unstiffened, full, or a list of energy terms
///         jacobians: true,                   // optional: implement ffrf::FlexibleBodyJacobians as well
///         fma: auto,                         // optional: auto (default), on, off
///         strategy: auto,                    // optional: auto (default), straight_line, lanes
///         layout_tolerance: 1e-15,           // optional: what counts as zero, relative to its Gram scale
///     }
/// }
/// ```
///
/// The result is a unit struct that implements `ffrf::FlexibleBody<scalar>`, `Observables`, `DenseForms<M, N, scalar>` and
/// `NamedMarkers`, with a constant for each marker of the model. When the model file changes, the crate is rebuilt. A model that fails its consistency checks is an error
/// at the path: see `ffrf_model::ReducedBody::check`.
///
/// With `scalar: generic` it implements that trait for every real number type of nalgebra: f64, f32, and dual numbers
/// such as those of the crate num-dual, through which kernels and whole simulations can be differentiated. Constants
/// stay f64; products and sums are not contracted, and lanes do not use the processor's registers, so f64 or f32 is
/// the choice for speed.
///
/// Without a model the invariants are supplied at run time; what the layout says is zero or one is no field of the
/// struct and costs nothing:
///
/// ```text
/// ffrf::flexible_body! {
///     pub struct Arm {
///         modes: 2,
///         layout: {                          // what is not named is as general as it can be
///             first_moment: zero,            // zero or dense
///             modal_first_moment: zero,      // zero or dense
///             second_moment: diagonal,       // diagonal or dense
///             position_mode_moment: symmetric, // zero, diagonal, symmetric, antisymmetric or dense
///             mode_mode_moment: dense,       // the same
///             modal_mass: identity,          // identity, diagonal or dense
///             stiffness: diagonal,           // zero, identity, diagonal or dense
///             damping: zero,                 // the same
///         },
///     }
/// }
/// ```
///
/// Its fields are public, so its method `check()` says whether what stands in them can be a body: call it once before
/// simulating; its error names the field, the index, the number found and what was expected.
///
/// A `family` in the place of a `struct` is a module of many bodies from one model, one for each combination; other keys
/// hold for all of them:
///
/// ```text
/// ffrf::flexible_body! {
///     /// Rotors.
///     pub family rotors {
///         model: "models/rotor.ffrf.json",
///         modes: [0, 2, 4, 8],               // numbers of modes, each time the first ones
///         fidelity: [full, linear],          // optional: levels, or lists of terms in brackets (default: full)
///         scalar: [f64, f32],                // optional (default: f64)
///     }
/// }
/// ```
///
/// Members are `rotors::M4LinearF32` and so on, `Terms1` for the first list of terms; without modes there is one for each
/// number type, because all fidelities are then the same. `rotors::MEMBERS` says what they are. `rotors::for_each(&mut visitor)`
/// calls a `ffrf::FamilyVisitor` with each, compiled on its own; `rotors::members!(callback)` calls
/// `callback! { M4LinearF32, 4, "linear", f32 }` for each, where code has to name the type, as `mechanism!` has.
#[proc_macro]
pub fn flexible_body(input: TokenStream) -> TokenStream {
    expand::flexible_body(input.into()).into()
}

/// Composes bodies, joints, drives, forces and sensors into one mechanism of static size.
///
/// ```text
/// ffrf::mechanism! {
///     /// A slider-crank.
///     pub struct SliderCrank {
///         bodies: {
///             crank: rigid { mass: 0.5, inertia: [2e-4, 4e-4, 5e-4], markers: { PIN: [0.04, 0.0, 0.0] } },
///             rod: Rod,                          // made by flexible_body!; `[Rod; 8]` for equal ones
///             piston: rigid Piston,              // a type without modes; `free ...` if it may have no joint
///         },
///         gravity: [0.0, 0.0, -9.81],            // optional: m/s², inertial
///         joints: {                              // between BODY, BODY.MARKER, BODY[i].MARKER, BODY.at([..]), ground
///             main: revolute(ground, crank, axis: z),
///             big_end: revolute(crank.PIN, rod.BIG_END, axis: z),
///             small_end: spherical(rod.SMALL_END, piston.PIN),
///             guide: prismatic(ground, piston.PIN, axis: x),
///         },
///         drives: { motor: angle(main, polynomial: [0.0, 100.0]) },
///         forces: { friction: torsion_spring(big_end, stiffness: 0.0, damping: 1e-4) },
///         sensors: { stroke: position(piston), bearing: reaction_force(main) },
///         accelerations: slider_crank::accelerations, // optional: a function that was printed for this mechanism
///         implicit_accelerations: slider_crank::stage, // optional: the same for linearly implicit stages
///         scalar: f64,                           // optional: f64 (default), f32 or generic
///     }
/// }
/// ```
///
/// The result is the model `SliderCrank`, which implements `ffrf::mechanism::Assembly`, and its `SliderCrankState` with a
/// field for each body; `model.in_motion(state)` takes steps, sensors are methods of the model. Every mistake is an error
/// at its place. All kinds and options: `docs/mechanisms.md`.
///
/// The function of `accelerations` holds the numbers of the whole mechanism, and explicit steps take its result in place of
/// solving the equations of all joints. It does not follow a model whose bodies, gravity, forces or triads (`met_in`) are
/// not those that it was printed for: `mechanism.straight_difference()` tells. That of `implicit_accelerations` is the same to
/// linearly implicit steps and to the corrections of implicit methods; `mechanism.straight_implicit_difference(gamma_h)` tells.
/// Those of `projection` and `implicit_projection` correct the state behind explicit and implicit steps.
#[proc_macro]
pub fn mechanism(input: TokenStream) -> TokenStream {
    mechanism::mechanism(input.into()).into()
}
