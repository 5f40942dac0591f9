//! Formulation: from the invariants of a body to the expressions of its kernels.
//!
//! The kernels here are hand-arranged for the least work; that they are the derivatives of the kinetic energy is
//! proven by comparing them, as polynomials, with [`crate::derive`].

mod constant_factors;
mod factors;
mod kernel;
mod modal_mass;
mod observables;
mod pivot;
mod solve;
mod state;
mod structured;

pub use constant_factors::ConstantFactors;
pub use kernel::{Argument, Kernel, KernelKind, OutputShape};
pub use modal_mass::ModalFactors;
pub use observables::{
    angular_momentum, elastic_energy, gravity_force, internal_force, kinetic_energy, linear_momentum,
};
pub use solve::forward_dynamics;
pub use state::State;
pub use structured::{DeformedBody, mass_matrix, quadratic_velocity};
