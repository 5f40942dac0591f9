//! Normal modes in the coordinates y: of the unsupported part, or with its interfaces at rest.

use faer::Mat;

use crate::FeError;

use super::ComponentModeError;
use super::condition::Condition;
use super::{dense_modes, lanczos};

/// Largest problem that is solved densely: there both methods take about a second.
const DENSE_LIMIT: usize = 900;

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
