//! Formulation: from the invariants of a body to the expressions of its kernels.
//!
//! The kernels here are hand-arranged for the least work; that they are the derivatives of the kinetic energy is
//! proven by comparing them, as polynomials, with [`crate::derive`]. [`KERNELS`] is the table of them all; [`Jacobian`]
//! differentiates them.

mod constant_factors;
mod draft;
mod factors;
mod jacobian;
mod kernel;
pub mod kernels;
mod modal_mass;
mod observables;
mod pivot;
mod signature;
mod solve;
mod state;
mod structured;

pub use constant_factors::ConstantFactors;
pub use draft::Draft;
pub use jacobian::{Jacobian, Variable};
pub use kernel::Kernel;
pub use kernels::{Definition, Interface, JACOBIANS, KERNELS, Loop, PREPARE};
pub use modal_mass::ModalFactors;
pub use observables::{
    angular_momentum, elastic_energy, gravity_force, internal_force, kinetic_energy, linear_momentum,
};
pub use signature::{Output, Shape, Signature};
pub use solve::forward_dynamics;
pub use state::State;
pub use structured::{DeformedBody, mass_matrix, quadratic_velocity};
