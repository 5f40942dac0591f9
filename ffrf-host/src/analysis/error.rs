//! Why an analysis has no result.

use ffrf_runtime::StepError;
use thiserror::Error;

use crate::scene::SceneError;

/// Why an analysis has no result.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum AnalysisError {
    /// The scene cannot be assembled.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// No accelerations exist in a state.
    #[error("the equations have no solution there: {0}")]
    Step(#[from] StepError),
    /// A body has no positive definite mass matrix.
    #[error("body `{body}`: its mass matrix is not positive definite")]
    Mass {
        /// The body.
        body: String,
    },
    /// The search for an equilibrium did not end at one.
    #[error(
        "no equilibrium found in {iterations} iterations: accelerations of {residual:.3e} are left, {tolerance:.1e} are allowed \
         (both measured by kinetic energy)"
    )]
    NoEquilibrium {
        /// Iterations done.
        iterations: usize,
        /// What is left, √(aᵀ M a).
        residual: f64,
        /// What is allowed.
        tolerance: f64,
    },
    /// A joint cannot rest, or turn with everything else: a drive moves it, or it leads elsewhere.
    #[error(
        "joint `{joint}` would be left at {rate:.3e} (m or rad) per second: there is no state of rest, or of steady rotation"
    )]
    Driven {
        /// The joint or its drive.
        joint: String,
        /// Rate of its residual at rest.
        rate: f64,
    },
    /// An eigenvalue iteration or a singular value decomposition did not converge.
    #[error("{what} did not converge")]
    NotConverged {
        /// What was computed.
        what: &'static str,
    },
    /// A name that nothing has, or that has not what is asked of it.
    #[error("`{found}`: expected {expected}; there are {known}")]
    Name {
        /// The name.
        found: String,
        /// What is expected.
        expected: &'static str,
        /// The names that would do.
        known: String,
    },
    /// A steady rotation that the mechanism does not have.
    #[error("no steady rotation at {speed} rad/s: {reason}")]
    NotSteady {
        /// Speed. Units: rad/s.
        speed: f64,
        /// Why.
        reason: String,
    },
    /// A number that cannot be.
    #[error("{what}: expected {expected}, found {found}")]
    Value {
        /// What the number is.
        what: &'static str,
        /// What is expected.
        expected: &'static str,
        /// What was found.
        found: String,
    },
}
