//! Why a scene has no straight-line code.

use ffrf_runtime::StepError;
use thiserror::Error;

/// Why a scene has no straight-line code.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum StraightLineError {
    /// Something whose value is not known when the code is generated.
    #[error("{what}: what it exerts is not known when code is generated, expected a scene without it")]
    Unknown {
        /// What it is, by its key in the scene file.
        what: String,
    },
    /// The equations ask for a function that straight-line code does not have.
    #[error(
        "the equations need {functions}, expected sums, products, quotients and square roots alone: a scene without torsion springs"
    )]
    Functions {
        /// Names of the functions.
        functions: String,
    },
    /// Accelerations that draw residuals back by gains of the step.
    #[error("constraints = \"baumgarte\": gains follow the step, expected another treatment")]
    Gains,
    /// There are no accelerations at the initial state.
    #[error("at the initial state: {0}")]
    Accelerations(StepError),
}
