//! Equations of motion derived from the kinetic energy: the reference that the fast kernels are proven against.
//!
//! [`KineticEnergy`] writes E once, term by term, from the raw invariants. [`EulerPoincare`] differentiates it.
//! Nothing there is arranged for speed. [`Jacobian`] differentiates the fast kernels.

mod energy;
mod euler_poincare;
mod jacobian;

pub use energy::{KineticEnergy, Matrix, RawInertia};
pub use euler_poincare::EulerPoincare;
pub use jacobian::{Jacobian, Variable};
