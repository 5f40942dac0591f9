//! Normal modes in the coordinates y: of the unsupported part, or with its interfaces at rest.

use faer::Mat;

use crate::FeError;
use crate::modes::{lowest_pairs, subspace_size};

use super::ComponentModeError;
use super::condition::Condition;
use super::dense_modes;

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
    let is_dense = dimension <= DENSE_LIMIT || dimension < 2 * subspace_size(wanted);
    let (values, shapes) =
        if is_dense { dense_modes::all(condition)? } else { sparse(condition, wanted, progress)? };
    if values.len() < wanted {
        return Err(ComponentModeError::TooFewModes { wanted, available: values.len() }.into());
    }
    let method = if is_dense { "dense reduction" } else { "shift-inverted block Lanczos" };
    Ok(NormalModes {
        values: values[..wanted].to_vec(),
        shapes: shapes.get(.., 0..wanted).to_owned(),
        method: format!("{method} on {} coordinates", condition.coordinates().dimension()),
    })
}

/// At least `wanted` of the lowest pairs, by the solver of [`crate::modes`].
fn sparse(
    condition: Condition<'_>,
    wanted: usize,
    progress: &mut dyn FnMut(usize),
) -> Result<(Vec<f64>, Mat<f64>), FeError> {
    let shapes = lowest_pairs(&condition, wanted, None, progress)?.shapes;
    let forces = condition.coordinates().stiffness_times(shapes.as_ref());
    // The Rayleigh quotient of a shape of unit modal mass is exact to the square of its residual.
    let value = |j: usize| (shapes.col(j).transpose() * forces.col(j), j);
    let mut order: Vec<(f64, usize)> = (0..shapes.ncols()).map(value).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    let sorted = Mat::from_fn(shapes.nrows(), shapes.ncols(), |i, j| shapes[(i, order[j].1)]);
    Ok((order.iter().map(|pair| pair.0).collect(), sorted))
}
