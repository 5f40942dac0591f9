//! What the user asks of the reduction.

use faer::Mat;
use ffrf_model::Units;

/// What the reduced body is called, how it is damped and where it is seen.
#[derive(Debug, Clone)]
pub struct ReductionOptions {
    /// A line for people.
    pub title: String,
    /// Which units the numbers are in, if that is known.
    pub units: Option<Units>,
    /// Modal damping.
    pub damping: Damping,
    /// Points where forces act and where motion is observed.
    pub markers: Vec<MarkerRequest>,
    /// Modal stiffness K_ff to use in place of ΨᵀKΨ. Shape: M x M, symmetric.
    pub modal_stiffness: Option<Mat<f64>>,
}

impl Default for ReductionOptions {
    fn default() -> Self {
        Self {
            title: String::new(),
            units: None,
            damping: Damping::None,
            markers: Vec::new(),
            modal_stiffness: None,
        }
    }
}

/// Modal damping D_ff.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Damping {
    /// None.
    #[default]
    None,
    /// Fractions ζ of critical damping of the eigenmodes of (K_ff, Θ_ff) in ascending order of frequency:
    /// one for all, or one for each.
    ModalRatio(Vec<f64>),
    /// D_ff = α Θ_ff + β K_ff.
    Rayleigh {
        /// Mass-proportional coefficient α. Units: 1/s.
        alpha: f64,
        /// Stiffness-proportional coefficient β. Units: s.
        beta: f64,
    },
}

/// A marker to be made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MarkerRequest {
    /// Name, unique in the body; letters, digits and underscores.
    pub name: String,
    /// Row numbers of its nodes in the node table.
    pub nodes: Vec<usize>,
}
