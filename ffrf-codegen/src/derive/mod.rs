//! Equations of motion derived from the kinetic energy: the reference that the fast kernels are proven against.
//!
//! [`KineticEnergy`] writes E once, term by term, from the raw invariants. [`EulerPoincare`] differentiates it.
//! Nothing there is arranged for speed.

mod energy;
mod euler_poincare;

pub use energy::KineticEnergy;
pub use euler_poincare::EulerPoincare;
