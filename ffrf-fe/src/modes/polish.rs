//! Rayleigh-Ritz on the shapes found: orthonormal to round-off, with eigenvalues exact to the square of their error.

use faer::Mat;

use super::ModeError;
use super::account::GROUP;
use super::block::{rotate, symmetrised, tall_gram};
use super::dense::generalised_eigen;
use super::problem::Problem;
use super::rigid::RigidModes;

/// Removes what is left of rigid motion and diagonalises K and M on the span of the shapes, in their memory.
///
/// Eigenvalues are ascending, shapes mass-orthonormal.
/// Errors: [`ModeError::NotPositiveDefinite`] if the shapes are linearly dependent.
pub(crate) fn polish(
    problem: &Problem<'_>,
    rigid: &RigidModes,
    mut shapes: Mat<f64>,
) -> Result<(Vec<f64>, Mat<f64>), ModeError> {
    let count = shapes.ncols();
    if count == 0 {
        return Ok((Vec::new(), shapes));
    }
    rigid.remove_from(&mut shapes);
    let (mut mass, mut stiffness) = (Mat::zeros(count, count), Mat::zeros(count, count));
    for first in (0..count).step_by(GROUP) {
        let end = (first + GROUP).min(count);
        let group = shapes.get(.., first..end);
        let product = problem.mass_times(group);
        mass.as_mut().get_mut(.., first..end).copy_from(tall_gram(
            shapes.as_ref(),
            product.as_ref(),
            problem.threads,
        ));
        let product = problem.stiffness_times(group);
        stiffness.as_mut().get_mut(.., first..end).copy_from(tall_gram(
            shapes.as_ref(),
            product.as_ref(),
            problem.threads,
        ));
    }
    let (values, rotation) =
        generalised_eigen(symmetrised(stiffness.as_ref()).as_ref(), symmetrised(mass.as_ref()).as_ref())?;
    rotate(shapes.as_mut(), rotation.as_ref(), problem.threads);
    rigid.remove_from(&mut shapes);
    Ok((values, shapes))
}
