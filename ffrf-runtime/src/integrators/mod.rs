//! Integrators, one file each, written once for every [`System`].

mod departure;
mod dormand_prince;
mod energy_momentum;
mod exponential;
mod generalised_alpha;
mod linearly_implicit;
mod linearly_implicit_euler;
mod mixing;
mod radau;
mod radau_memory;
mod runge_kutta;
mod secants;
mod step;
mod symplectic_euler;
mod system;
mod watched;

pub use departure::Departure;
pub use dormand_prince::{
    ControlledStep, DenseOutput, step_dormand_prince, try_dormand_prince, try_dormand_prince_dense,
};
pub use energy_momentum::EnergyMomentum;
pub use exponential::{Exponential, ExponentialSystem, Forcing, step_exponential};
pub use generalised_alpha::{AlphaMemory, GeneralisedAlpha};
pub use linearly_implicit::step_linearly_implicit;
pub use linearly_implicit_euler::step_linearly_implicit_euler;
pub use radau::{RadauCoefficients, RadauIIA};
pub use radau_memory::RadauMemory;
pub use runge_kutta::step_rk4;
pub use step::{Drift, LocalError, StepError, StepReport, Tolerances};
pub use symplectic_euler::step_symplectic_euler;
pub use system::{ConservingSystem, Correction, ImplicitSystem, StiffSystem, System, VectorSpace};

pub use watched::Watched;

pub(crate) use linearly_implicit::advance_linearly_implicit;
pub(crate) use runge_kutta::advance_rk4;
pub(crate) use system::{displaced, elastic_at_rest, too_large};
