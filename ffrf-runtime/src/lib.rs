//! `no_std` runtime for generated flexible bodies: the [`FlexibleBody`] trait, states, rotations, integrators.
//!
//! - [`body`]: [`FlexibleBody`] is what the generator implements, constants and one function of the state, whose result
//!   [`Prepared`] serves forces, constraints and outputs; [`Observables`] and [`DenseForms`] are what can be seen of it;
//!   [`FreeBody`] is a body with [`State`] and time; [`Marker`] is a point where forces act and joints hold.
//! - [`forces`]: every [`Load`].
//! - [`integrators`]: [`step_rk4`] (explicit, order 4), [`step_linearly_implicit`] (stiff modes, order 2) and others, for
//!   every [`System`].
//! - [`mechanism`]: bodies, [`joints`] and force elements as one system; [`mechanism::Mechanism`] is a mechanism with state and time.
//! - [`forms`] makes the inertial and the Euler-parameter form of the equations out of the kernels' one.
//! - [`rotation`] states the one convention of rotations.
//! - [`InvariantError`] is what `check` of a body says whose invariants come at run time.
//!
//! Nothing here allocates or panics; a step does bounded work and either succeeds or leaves the state as it was.
//!
//! Features: `std` (default) takes float functions from the standard library, `libm` from the crate of that
//! name, for targets without one. At least one of the two is needed. `host-simd` (default) lets kernels over lanes compute
//! in the registers that an x86-64 processor is found to have when running; their products and sums are contracted then.
//!
//! Current limitations: bodies without geometric stiffening; rows of joints are dense within a body.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(test, feature = "std"))]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!(
    "ffrf-runtime needs float functions: turn on the feature `std` (hosts) or `libm` (targets without one)"
);

pub mod body;
pub mod forces;
pub mod forms;
#[doc(hidden)]
pub mod generated_support;
pub mod integrators;
mod invariants;
mod jacobians;
pub mod joints;
#[doc(hidden)]
pub mod lanes;
mod math;
pub mod mechanism;
pub mod relations;
pub mod rotation;
mod six;

pub use body::{
    DenseForms, Eliminated, Envelope, EquationsOfMotion, Factored, FamilyMember, FamilyVisitor, FlexibleBody,
    FreeBody, FreeSystem, GeneralisedForce, Increment, Load, Marker, MarkerMotion, MarkerStep, ModalFactors,
    ModalMatrix, ModalVector, Motion, NamedMarkers, Observables, Oscillators, Pair, PairSystem, PlacedMarker,
    Prepared, RigidBody, SectionMarker, State, StressMarker, Wrench, von_mises,
};
pub use forces::{Frame, Gravity, MarkerLoad};
pub use integrators::{
    AlphaMemory, ConservingSystem, ControlledStep, Correction, DenseOutput, Departure, Drift, EnergyMomentum,
    Exponential, ExponentialSystem, Forcing, GeneralisedAlpha, ImplicitSystem, LocalError, RadauCoefficients,
    RadauIIA, RadauMemory, StepError, StepReport, StiffSystem, System, Tolerances, VectorSpace, Watched,
    step_dormand_prince, step_exponential, step_linearly_implicit, step_linearly_implicit_euler, step_rk4,
    step_symplectic_euler, try_dormand_prince, try_dormand_prince_dense,
};
pub use invariants::{InvariantError, InvariantExpectation, InvariantIndex};
pub use jacobians::{AccelerationJacobian, FlexibleBodyJacobians, ResidualJacobian};
pub use nalgebra;
