//! Every normal mode of a small problem, by dense reduction to a standard eigenproblem.

use faer::linalg::triangular_solve::solve_upper_triangular_in_place;
use faer::{Mat, Par};

use crate::FeError;
use crate::modes::{cholesky, gram, product};

use super::condition::Condition;
use super::jacobi;

/// Inverse eigenvalues below this part of the largest, times the size, are round-off of shapes without mass.
const FINITE: f64 = 1e-14;

/// All eigenvalues ω² in ascending order, and shapes with unit modal mass.
///
/// On a basis Z of the admissible shapes, with ZᵀKZ = L Lᵀ, the pairs (θ, x) of L⁻¹ ZᵀMZ L⁻ᵀ give ω² = 1/θ and
/// y = Z L⁻ᵀ x / √θ. Shapes without mass have θ = 0 and are left out.
/// Errors: a stiffness that is not positive definite on the admissible shapes.
pub(crate) fn all(condition: Condition<'_>) -> Result<(Vec<f64>, Mat<f64>), FeError> {
    let coordinates = condition.coordinates();
    let admissible = complement(&condition.constraint_columns())?;
    let stiffness = coordinates.stiffness_gram(admissible.as_ref());
    let mass = coordinates.mass_gram(admissible.as_ref());
    let lower = cholesky(stiffness.as_ref(), "the stiffness of admissible shapes")?;
    let (inverse, vectors) = jacobi::eigen(jacobi::congruent(lower.as_ref(), mass.as_ref()).as_ref())?;
    let size = inverse.len();
    let largest = inverse.last().copied().unwrap_or(0.0);
    let finite = inverse.iter().filter(|&&theta| theta > FINITE * size as f64 * largest).count();
    let mut shapes =
        Mat::from_fn(size, finite, |i, j| vectors[(i, size - 1 - j)] / inverse[size - 1 - j].sqrt());
    solve_upper_triangular_in_place(lower.transpose(), shapes.as_mut(), Par::Seq);
    let values = inverse.iter().rev().take(finite).map(|theta| theta.recip()).collect();
    Ok((values, product(admissible.as_ref(), shapes.as_ref(), Par::Seq)))
}

/// An orthonormal basis of the shapes y with Cᵀy = 0, by a complete QR factorisation of C.
fn complement(columns: &Mat<f64>) -> Result<Mat<f64>, FeError> {
    // Columns of unit length: translations and rotations have other units.
    let mut scaled = columns.clone();
    for j in 0..scaled.ncols() {
        let norm = scaled.col(j).norm_l2();
        if norm > 0.0 {
            scaled.col_as_slice_mut(j).iter_mut().for_each(|x| *x /= norm);
        }
    }
    let (size, count) = (scaled.nrows(), scaled.ncols());
    if count == 0 {
        return Ok(Mat::identity(size, size));
    }
    let whole = scaled.qr().compute_Q();
    let mut rest = whole.get(.., count..).to_owned();
    // Once more against the columns themselves, so that the conditions hold to round-off.
    let (values, vectors) = jacobi::eigen(gram(scaled.as_ref(), scaled.as_ref(), Par::Seq).as_ref())?;
    let missed = gram(scaled.as_ref(), rest.as_ref(), Par::Seq);
    let mut modal = gram(vectors.as_ref(), missed.as_ref(), Par::Seq);
    for j in 0..modal.ncols() {
        for (i, value) in values.iter().enumerate() {
            modal[(i, j)] /= value;
        }
    }
    let factors = product(vectors.as_ref(), modal.as_ref(), Par::Seq);
    rest -= product(scaled.as_ref(), factors.as_ref(), Par::Seq);
    Ok(rest)
}
