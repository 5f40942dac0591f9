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
    /// Fractions ζ of critical damping by the frequency of the eigenmode, in ascending bands of which the last is open.
    Bands(Vec<DampingBand>),
    /// D_ff = α Θ_ff + β K_ff.
    Rayleigh {
        /// Mass-proportional coefficient α. Units: 1/s.
        alpha: f64,
        /// Stiffness-proportional coefficient β. Units: s.
        beta: f64,
    },
}

/// A damping ratio for a range of frequencies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DampingBand {
    /// Up to where the band reaches, from where the one before ends; infinity for the last. Units: Hz; cycles per unit of time where
    /// the units are not known.
    pub below: f64,
    /// Fraction ζ of critical damping.
    pub ratio: f64,
}

impl Damping {
    /// What multibody programs take where nothing else is known: 1 % below 100 Hz, 10 % below 1 kHz, 100 % above.
    pub fn common_bands() -> Self {
        let band = |below, ratio| DampingBand { below, ratio };
        Self::Bands(vec![band(100.0, 0.01), band(1000.0, 0.1), band(f64::INFINITY, 1.0)])
    }
}

/// In words, for the model file.
impl std::fmt::Display for Damping {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::ModalRatio(ratios) => match ratios.as_slice() {
                [ratio] => write!(f, "ratio {ratio} of every mode"),
                _ => write!(f, "ratios of the modes by ascending frequency {ratios:?}"),
            },
            Self::Bands(bands) => {
                f.write_str("ratios by frequency")?;
                for (k, DampingBand { below, ratio }) in bands.iter().enumerate() {
                    let separator = if k == 0 { "" } else { "," };
                    match below.is_finite() {
                        true => write!(f, "{separator} {ratio} below {below} Hz")?,
                        false => write!(f, "{separator} {ratio} above")?,
                    }
                }
                Ok(())
            }
            Self::Rayleigh { alpha, beta } => write!(f, "Rayleigh, {alpha} M + {beta} K"),
        }
    }
}

/// A marker to be made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MarkerRequest {
    /// Name, unique in the body; letters, digits and underscores.
    pub name: String,
    /// Row numbers of its nodes in the node table.
    pub nodes: Vec<usize>,
}
