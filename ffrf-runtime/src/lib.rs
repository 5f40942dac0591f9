//! `no_std` runtime for generated flexible bodies: the [`FlexibleBody`] trait, states, rotations, integrators.
//!
//! - [`FlexibleBody`] is what the generator implements: kernels, resolved in the body frame.
//! - [`FreeBody`] is a body with [`State`] and time; it steps under a [`Load`] and knows its energy and momentum.
//! - [`step_rk4`] is explicit (order 4), [`step_linearly_implicit`] is for stiff modes (order 2).
//! - [`Marker`] is a point where forces act and joints hold, with its Jacobians; [`LeverArm`] says about which position.
//! - [`forms`] makes the inertial and the Euler-parameter form of the equations out of the kernels' one.
//! - [`rotation`] states the one convention of rotations.
//! - [`InvariantError`] is what `check` of a body says whose invariants come at run time.
//!
//! Nothing here allocates or panics; a step does bounded work and either succeeds or leaves the state as it was.
//!
//! Features: `std` (default) takes float functions from the standard library, `libm` from the crate of that
//! name, for targets without one. At least one of the two is needed.
//!
//! Current limitations: one body at a time, without joints; fixed steps.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(test, feature = "std"))]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!(
    "ffrf-runtime needs float functions: turn on the feature `std` (hosts) or `libm` (targets without one)"
);

mod augmented_mass;
mod flexible_body;
pub mod forms;
mod free_body;
#[doc(hidden)]
pub mod generated_support;
mod invariants;
mod jacobians;
#[doc(hidden)]
pub mod lanes;
mod lever_arm;
mod linearly_implicit;
mod load;
mod marker;
mod phase;
pub mod rotation;
mod runge_kutta;
mod state;
mod step;

pub use flexible_body::{EquationsOfMotion, FlexibleBody};
pub use free_body::FreeBody;
pub use invariants::{InvariantError, InvariantExpectation, InvariantIndex};
pub use jacobians::{AccelerationJacobian, FlexibleBodyJacobians, ResidualJacobian};
pub use lever_arm::LeverArm;
pub use linearly_implicit::step_linearly_implicit;
pub use load::{Frame, Gravity, Load, MarkerLoad};
pub use marker::Marker;
pub use nalgebra;
pub use runge_kutta::step_rk4;
pub use state::State;
pub use step::{LocalError, StepError, StepReport};
