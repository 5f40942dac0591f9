//! The mode basis Ψ.

use faer::Mat;
use ffrf_model::Mode;

/// Mode shapes Ψ and what is known of each mode.
#[derive(Debug, Clone)]
pub struct ModeBasis {
    /// Mode shapes Ψ. Shape: 3N x M.
    pub shapes: Mat<f64>,
    /// Kind and frequency of each mode.
    pub modes: Vec<Mode>,
}
