//! Integrators, one file each, written once for every [`System`].

mod linearly_implicit;
mod runge_kutta;
mod step;
mod system;

pub use linearly_implicit::step_linearly_implicit;
pub use runge_kutta::step_rk4;
pub use step::{Drift, LocalError, StepError, StepReport, Tolerances};
pub use system::{StiffSystem, System, VectorSpace};
