//! Why a study cannot be made; what a single configuration fails by is an outcome, no error.

use thiserror::Error;

use crate::scene::SceneError;

/// Why a study of a scene cannot be made.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TradeoffError {
    /// The scene cannot be read, composed or assembled.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The operations of a body cannot be counted.
    #[error("operation counts: {0}")]
    Counts(#[from] ffrf_codegen::CodegenError),
    /// A quantity that the scene does not have.
    #[error("quantity `{found}`: expected one of {known}")]
    Quantity {
        /// What was asked for.
        found: String,
        /// What there is.
        known: String,
    },
    /// Modes of a body that the scene does not have, or that is rigid.
    #[error("{0}")]
    Modes(String),
    /// The reference could not be computed.
    #[error("the reference (all modes, tolerance {tolerance:e}): {reason}")]
    Reference {
        /// Its relative tolerance per step. Units: 1.
        tolerance: f64,
        /// When and why.
        reason: String,
    },
    /// Nothing that may be chosen keeps the budget.
    #[error("no configuration keeps the error {error:e}: {tried}")]
    Budget {
        /// The budget.
        error: f64,
        /// What was tried, and what came of it.
        tried: String,
    },
    /// Nothing that may be chosen ends its run with steps that there is time for.
    #[error("no configuration runs with steps of {step:e} s and {operations:.3e} operations: {tried}")]
    StepBudget {
        /// Operations that there is time for.
        operations: f64,
        /// The step. Units: s.
        step: f64,
        /// What was tried, and what came of it.
        tried: String,
    },
    /// A model was asked of a body that has none.
    #[error("body {index} (from 0) is rigid: it has no model")]
    Rigid {
        /// Its index.
        index: usize,
    },
    /// An outcome could not be kept.
    #[error(transparent)]
    Keep(#[from] std::io::Error),
}
