//! The scale of the lowest elastic eigenvalue, before anything is solved.

use faer::{Mat, Par};

use super::ModeError;
use super::block::{gram, subtract_product, symmetrised};
use super::problem::Problem;
use super::rigid::{RigidModes, orthonormalise};
use super::symmetric_eigen::symmetric_eigen;

/// An upper estimate of the lowest elastic eigenvalue of the unsupported part, (rad/s)².
///
/// Ritz values on the 18 quadratic displacement fields x_i x_j e_k, orthogonal to rigid motion: bending of
/// a slender part is among them up to a factor near 1.4. The estimate sets the shift of the solver and the
/// scale below which an eigenvalue counts as zero; no result depends on its accuracy.
/// Errors: [`ModeError::NoStrain`] if no such field has both mass and strain energy.
pub(crate) fn elastic_scale(problem: &Problem<'_>, rigid: &RigidModes) -> Result<f64, ModeError> {
    let fields = quadratic_fields(problem, rigid.centre, rigid.size);
    let mut fields = problem.restrict(fields.as_ref());
    for _ in 0..2 {
        let coefficients = gram(rigid.mass_shapes.as_ref(), fields.as_ref(), Par::Seq);
        subtract_product(fields.as_mut(), rigid.shapes.as_ref(), coefficients.as_ref(), Par::Seq);
    }
    let fields = orthonormalise(problem, fields, 1e-12);
    if fields.ncols() == 0 {
        return fallback(problem);
    }
    let stiffness = gram(fields.as_ref(), problem.stiffness_times(fields.as_ref()).as_ref(), Par::Seq);
    let (values, _) = symmetric_eigen(symmetrised(stiffness.as_ref()).as_ref())?;
    let largest = values.last().copied().unwrap_or(0.0);
    match values.into_iter().find(|&value| value > 1e-12 * largest) {
        Some(value) if value > 0.0 => Ok(value),
        _ => fallback(problem),
    }
}

/// Mean of K's diagonal over mean of M's, for parts too small to bend quadratically.
fn fallback(problem: &Problem<'_>) -> Result<f64, ModeError> {
    let (mut stiffness, mut mass) = (0.0, 0.0);
    for &dof in &problem.free {
        stiffness += problem.stiffness.get(dof, dof).copied().unwrap_or(0.0);
        mass += problem.model.mass.get(dof / 3, dof / 3).copied().unwrap_or(0.0);
    }
    if stiffness > 0.0 && mass > 0.0 {
        Ok(1e-3 * stiffness / mass)
    } else {
        Err(ModeError::NoStrain { stiffness, mass })
    }
}

fn quadratic_fields(problem: &Problem<'_>, centre: [f64; 3], size: f64) -> Mat<f64> {
    const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
    let positions = &problem.model.nodes.positions;
    let monomials = Mat::from_fn(positions.len(), 6, |node, pair| {
        let (i, j) = PAIRS[pair];
        let x = |axis: usize| (positions[node][axis] - centre[axis]) / size;
        x(i) * x(j)
    });
    Mat::from_fn(3 * positions.len(), 18, |dof, column| {
        if dof % 3 == column % 3 { monomials[(dof / 3, column / 3)] } else { 0.0 }
    })
}
