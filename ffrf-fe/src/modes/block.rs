//! Products of tall blocks of vectors and eigenvalues of small symmetric matrices, with explicit parallelism.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, self_adjoint_evd, self_adjoint_evd_scratch};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, MatRef, Par};

use super::ModeError;

/// A B.
pub(crate) fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>, par: Par) -> Mat<f64> {
    let mut result = Mat::zeros(a.nrows(), b.ncols());
    matmul(&mut result, Accum::Replace, a, b, 1.0, par);
    result
}

/// Aᵀ B.
pub(crate) fn gram(a: MatRef<'_, f64>, b: MatRef<'_, f64>, par: Par) -> Mat<f64> {
    product(a.transpose(), b, par)
}

/// X := X - A B.
pub(crate) fn subtract_product(x: MatMut<'_, f64>, a: MatRef<'_, f64>, b: MatRef<'_, f64>, par: Par) {
    matmul(x, Accum::Add, a, b, -1.0, par);
}

/// (A + Aᵀ) / 2.
pub(crate) fn symmetrised(a: MatRef<'_, f64>) -> Mat<f64> {
    Mat::from_fn(a.nrows(), a.ncols(), |i, j| 0.5 * (a[(i, j)] + a[(j, i)]))
}

/// Eigenvalues in ascending order and eigenvectors of a symmetric matrix (lower triangle read).
///
/// Errors: [`ModeError::EigenvaluesNotFound`] if the iteration fails, as it does on numbers that are not finite.
pub(crate) fn symmetric_eigen(a: MatRef<'_, f64>) -> Result<(Vec<f64>, Mat<f64>), ModeError> {
    let n = a.nrows();
    // One thread: the result must not depend on the number of threads.
    let par = Par::Seq;
    let mut memory =
        MemBuffer::new(self_adjoint_evd_scratch::<f64>(n, ComputeEigenvectors::Yes, par, Default::default()));
    let mut values = Diag::<f64>::zeros(n);
    let mut vectors = Mat::zeros(n, n);
    self_adjoint_evd(
        a,
        values.as_mut(),
        Some(vectors.as_mut()),
        par,
        MemStack::new(&mut memory),
        Default::default(),
    )
    .map_err(|_| ModeError::EigenvaluesNotFound { size: n })?;
    let values: Vec<f64> = values.column_vector().iter().copied().collect();
    if values.iter().any(|value| !value.is_finite()) {
        return Err(ModeError::EigenvaluesNotFound { size: n });
    }
    Ok((values, vectors))
}

/// Euclidean norm of one column.
pub(crate) fn column_norm(x: MatRef<'_, f64>, column: usize) -> f64 {
    x.col(column).norm_l2()
}
