//! Normal modes in the coordinates y: of the unsupported part, or with its interfaces at rest.

use faer::Mat;

use crate::FeError;

use super::ComponentModeError;
use super::constrained::Constrained;
use super::coordinates::Coordinates;
use super::flexibility::Flexibility;
use super::{dense_modes, lanczos};

/// Largest problem that is solved densely: there both methods take about a second.
const DENSE_LIMIT: usize = 900;

/// How the part is held while its normal modes are computed.
#[derive(Clone, Copy)]
pub(crate) enum Condition<'a> {
    /// Not at all: elastic modes of the unsupported part, orthogonal to rigid motion.
    Free(&'a Flexibility<'a>),
    /// The reference points of all interfaces at rest.
    Clamped(&'a Constrained<'a>),
}

impl Condition<'_> {
    pub fn coordinates(&self) -> &Coordinates<'_> {
        match self {
            Self::Free(flexibility) => flexibility.coordinates,
            Self::Clamped(constrained) => constrained.flexibility.coordinates,
        }
    }

    /// Displacements of forces under the condition.
    pub fn flexibility_times(&self, forces: Mat<f64>) -> Mat<f64> {
        match self {
            Self::Free(flexibility) => flexibility.elastic(forces),
            Self::Clamped(constrained) => constrained.clamped(forces.as_ref()),
        }
    }

    /// Linear conditions C y = 0 on admissible shapes, as columns Cᵀ.
    pub fn constraint_columns(&self) -> Mat<f64> {
        match self {
            Self::Free(flexibility) => flexibility.rigid.mass_shapes.clone(),
            Self::Clamped(constrained) => constrained.motion.forces(constrained.flexibility.coordinates),
        }
    }

    /// Number of independent admissible shapes.
    pub fn dimension(&self) -> usize {
        let conditions = match self {
            Self::Free(flexibility) => flexibility.rigid.count(),
            Self::Clamped(constrained) => constrained.motion.count(),
        };
        self.coordinates().dimension().saturating_sub(conditions)
    }
}

/// Normal modes: eigenvalues ω² ascending, shapes with unit modal mass.
pub(crate) struct NormalModes {
    /// ω². Units: (rad/s)².
    pub values: Vec<f64>,
    /// Shape: n x count.
    pub shapes: Mat<f64>,
    /// How they were found, in words.
    pub method: String,
}

/// The lowest `wanted` normal modes.
///
/// `progress` is told how many have converged.
/// Errors: more wanted than there are, no convergence.
pub(crate) fn normal_modes(
    condition: Condition<'_>,
    wanted: usize,
    progress: &mut dyn FnMut(usize),
) -> Result<NormalModes, FeError> {
    let dimension = condition.dimension();
    if wanted == 0 {
        let none = Mat::zeros(condition.coordinates().dimension(), 0);
        return Ok(NormalModes { values: Vec::new(), shapes: none, method: "no normal modes".to_owned() });
    }
    let is_dense = dimension <= DENSE_LIMIT || 3 * lanczos::subspace_size(wanted) > dimension;
    let (values, shapes) =
        if is_dense { dense_modes::all(condition)? } else { lanczos::lowest(condition, wanted, progress)? };
    if values.len() < wanted {
        return Err(ComponentModeError::TooFewModes { wanted, available: values.len() }.into());
    }
    let method = if is_dense { "dense reduction" } else { "inverse block Lanczos" };
    Ok(NormalModes {
        values: values[..wanted].to_vec(),
        shapes: shapes.get(.., 0..wanted).to_owned(),
        method: format!("{method} on {} coordinates", condition.coordinates().dimension()),
    })
}
