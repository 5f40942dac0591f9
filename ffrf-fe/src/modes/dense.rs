//! The dense solver: every eigenpair of a small problem, by reduction to a standard eigenproblem.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{
    LltError, LltRegularization, cholesky_in_place, cholesky_in_place_scratch,
};
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Mat, MatRef, Par};

use super::ModeError;
use super::block::{product, symmetrised};
use super::problem::Problem;
use super::rigid::RigidModes;
use super::symmetric_eigen::symmetric_eigen;

/// Eigenpairs found by a solver, rigid-body modes left out.
pub(crate) struct Pairs {
    /// Eigenvectors on the free degrees of freedom, in ascending order of λ = ω².
    pub shapes: Mat<f64>,
    /// True if the problem has no further elastic eigenpairs with finite eigenvalue.
    pub complete: bool,
}

/// The lowest `wanted` elastic eigenpairs (fewer if there are no more).
///
/// With K - σ M = L Lᵀ, σ < 0, and rigid motion deflated from M, the pairs (θ, y) of L⁻¹ M L⁻ᵀ give
/// λ = σ + 1/θ, φ = L⁻ᵀ y. Massless degrees of freedom have θ = 0 and drop out.
/// Errors: [`ModeError::NotPositiveDefinite`] if K has negative eigenvalues below σ.
pub(crate) fn lowest(
    problem: &Problem<'_>,
    rigid: &RigidModes,
    shift: f64,
    wanted: usize,
) -> Result<Pairs, ModeError> {
    let par = Par::Seq;
    let size = problem.dimension();
    let (stiffness, mass) = problem.dense();
    let shifted = Mat::from_fn(size, size, |i, j| stiffness[(i, j)] - shift * mass[(i, j)]);
    let factor = cholesky(shifted.as_ref(), "K - shift M")?;
    let lower = factor.as_ref();
    let mut reduced = mass - product(rigid.mass_shapes.as_ref(), rigid.mass_shapes.transpose(), par);
    solve_lower_triangular_in_place(lower, reduced.as_mut(), par);
    let mut reduced = reduced.transpose().to_owned();
    solve_lower_triangular_in_place(lower, reduced.as_mut(), par);
    let (inverse_values, vectors) = symmetric_eigen(symmetrised(reduced.as_ref()).as_ref())?;

    let largest = inverse_values.last().copied().unwrap_or(0.0);
    let smallest_finite = 1e-14 * size as f64 * largest;
    let finite = inverse_values.iter().filter(|&&theta| theta > smallest_finite).count();
    let elastic = finite.min(rigid.most_elastic(problem));
    let count = wanted.min(elastic);
    let mut shapes = Mat::from_fn(size, count, |i, j| vectors[(i, size - 1 - j)]);
    solve_upper_triangular_in_place(lower.transpose(), shapes.as_mut(), par);
    Ok(Pairs { shapes, complete: count == elastic })
}

/// Pairs of K y = λ M y for small dense matrices: λ ascending, YᵀMY = I.
///
/// Errors: [`ModeError::NotPositiveDefinite`] if M is not positive definite.
pub(crate) fn generalised_eigen(
    stiffness: MatRef<'_, f64>,
    mass: MatRef<'_, f64>,
) -> Result<(Vec<f64>, Mat<f64>), ModeError> {
    let factor = cholesky(mass, "the modal mass matrix")?;
    let lower = factor.as_ref();
    let mut reduced = stiffness.to_owned();
    solve_lower_triangular_in_place(lower, reduced.as_mut(), Par::Seq);
    let mut reduced = reduced.transpose().to_owned();
    solve_lower_triangular_in_place(lower, reduced.as_mut(), Par::Seq);
    let (values, mut vectors) = symmetric_eigen(symmetrised(reduced.as_ref()).as_ref())?;
    solve_upper_triangular_in_place(lower.transpose(), vectors.as_mut(), Par::Seq);
    Ok((values, vectors))
}

/// Lower Cholesky factor L of a small dense matrix; the upper triangle of the result is not zeroed.
///
/// Errors: [`ModeError::NotPositiveDefinite`].
pub(crate) fn cholesky(matrix: MatRef<'_, f64>, what: &str) -> Result<Mat<f64>, ModeError> {
    let size = matrix.nrows();
    let mut lower = matrix.to_owned();
    // One thread: the result must not depend on the number of threads.
    let par = Par::Seq;
    let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(size, par, Default::default()));
    cholesky_in_place(
        lower.as_mut(),
        LltRegularization::default(),
        par,
        MemStack::new(&mut memory),
        Default::default(),
    )
    .map_err(|LltError::NonPositivePivot { index }| ModeError::NotPositiveDefinite {
        what: what.to_owned(),
        pivot: index,
        size,
    })?;
    Ok(lower)
}
