//! Eigenvalues and eigenvectors of symmetric dense matrices, scaled and checked.
//!
//! The divide-and-conquer method of faer 0.24 compares differences of eigenvalues with 8 ε max(|d|, |z|), where z is of
//! order one whatever the size of the matrix. From 128 rows on it therefore takes eigenvalues of a small matrix, such
//! as an inverted stiffness, for equal where they differ by 1e-7 of the norm, and returns vectors that are no
//! eigenvectors. A matrix scaled to order one is free of that, and a check by a probe vector guards the rest.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{
    ComputeEigenvectors, SelfAdjointEvdParams, self_adjoint_evd, self_adjoint_evd_scratch,
};
use faer::{Auto, Mat, MatRef, Par, Spec};

use super::ModeError;
use super::block::product;
use super::random::Random;

/// Largest error of A x = V Λ Vᵀ x and x = V Vᵀ x, relative to the norms, per row: some tens of ε.
const ROUND_OFF: f64 = 1e-14;

/// Eigenvalues in ascending order and eigenvectors of a symmetric matrix (lower triangle read).
///
/// Errors: [`ModeError::EigenvaluesNotFound`] if the iteration fails, as it does on numbers that are not finite.
pub(crate) fn symmetric_eigen(a: MatRef<'_, f64>) -> Result<(Vec<f64>, Mat<f64>), ModeError> {
    let size = a.nrows();
    let not_found = || ModeError::EigenvaluesNotFound { size };
    let scale = power_of_two_near(a.norm_max()).ok_or_else(not_found)?;
    let scaled = Mat::from_fn(size, size, |i, j| a[(i.max(j), i.min(j))] / scale);
    let divide = <SelfAdjointEvdParams as Auto<f64>>::auto();
    let iterate = SelfAdjointEvdParams { recursion_threshold: usize::MAX, ..divide };
    for params in [divide, iterate] {
        if let Some((values, vectors)) = decompose(scaled.as_ref(), params.into())
            && is_decomposition(scaled.as_ref(), &values, vectors.as_ref())
        {
            return Ok((values.into_iter().map(|value| value * scale).collect(), vectors));
        }
    }
    Err(not_found())
}

fn decompose(a: MatRef<'_, f64>, params: Spec<SelfAdjointEvdParams, f64>) -> Option<(Vec<f64>, Mat<f64>)> {
    let size = a.nrows();
    // One thread: the result must not depend on the number of threads.
    let par = Par::Seq;
    let scratch = self_adjoint_evd_scratch::<f64>(size, ComputeEigenvectors::Yes, par, params);
    let mut memory = MemBuffer::new(scratch);
    let mut values = Diag::<f64>::zeros(size);
    let mut vectors = Mat::zeros(size, size);
    self_adjoint_evd(a, values.as_mut(), Some(vectors.as_mut()), par, MemStack::new(&mut memory), params)
        .ok()?;
    Some((values.column_vector().iter().copied().collect(), vectors))
}

/// Compares A x with V Λ Vᵀ x, and x with V Vᵀ x, for a vector x without pattern.
fn is_decomposition(a: MatRef<'_, f64>, values: &[f64], vectors: MatRef<'_, f64>) -> bool {
    let size = a.nrows();
    let mut probe = Mat::zeros(size, 1);
    if size > 0 {
        Random::new().fill(probe.col_as_slice_mut(0));
    }
    let parts = product(vectors.transpose(), probe.as_ref(), Par::Seq);
    let scaled_parts = Mat::from_fn(size, 1, |i, _| values[i] * parts[(i, 0)]);
    let image = product(a, probe.as_ref(), Par::Seq);
    let expected = product(vectors, scaled_parts.as_ref(), Par::Seq);
    let whole = product(vectors, parts.as_ref(), Par::Seq);
    let norm = values.iter().fold(0.0_f64, |norm, value| norm.max(value.abs()));
    let limit = ROUND_OFF * size as f64 * probe.norm_l2();
    // Written so that what is not a number fails.
    (image - expected).norm_l2() <= limit * norm && (probe - whole).norm_l2() <= limit
}

/// The power of two at or below a positive number, so that scaling rounds nothing; 1 for zero.
fn power_of_two_near(value: f64) -> Option<f64> {
    if !value.is_finite() {
        return None;
    }
    Some(if value.is_normal() { f64::from_bits(value.to_bits() & 0x7FF0_0000_0000_0000) } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Q Λ Qᵀ with Q a reflection.
    fn with_spectrum(values: &[f64]) -> Mat<f64> {
        let size = values.len();
        let mut direction = Mat::zeros(size, 1);
        Random::new().fill(direction.col_as_slice_mut(0));
        let squared = direction.squared_norm_l2();
        let reflection = Mat::from_fn(size, size, |i, j| {
            let identity = if i == j { 1.0 } else { 0.0 };
            identity - 2.0 * direction[(i, 0)] * direction[(j, 0)] / squared
        });
        let scaled = Mat::from_fn(size, size, |i, j| reflection[(i, j)] * values[j]);
        let a = product(scaled.as_ref(), reflection.transpose(), Par::Seq);
        Mat::from_fn(size, size, |i, j| 0.5 * (a[(i, j)] + a[(j, i)]))
    }

    /// Largest entry of A V - V Λ over the norm of A.
    fn residual(a: MatRef<'_, f64>, values: &[f64], vectors: MatRef<'_, f64>) -> f64 {
        let image = product(a, vectors, Par::Seq);
        let mut worst = 0.0_f64;
        for j in 0..a.ncols() {
            for i in 0..a.nrows() {
                worst = worst.max((image[(i, j)] - vectors[(i, j)] * values[j]).abs());
            }
        }
        worst / a.norm_max()
    }

    #[test]
    fn vectors_of_small_and_graded_matrices_are_eigenvectors() {
        for size in [5, 127, 128, 200, 300] {
            for scale in [1e-300, 1e-12, 1.0, 1e12, 1e300] {
                let values: Vec<f64> = (0..size).map(|i| scale * (i as f64 + 1.0).powi(-3)).collect();
                let a = with_spectrum(&values);
                let (_, vectors) = symmetric_eigen(a.as_ref()).expect("finite entries");
                let quotients: Vec<f64> = (0..size)
                    .map(|j| {
                        let x = vectors.get(.., j..j + 1);
                        product(x.transpose(), product(a.as_ref(), x, Par::Seq).as_ref(), Par::Seq)[(0, 0)]
                    })
                    .collect();
                let error = residual(a.as_ref(), &quotients, vectors.as_ref());
                assert!(error < 1e-14 * size as f64, "size {size}, scale {scale:e}: {error:e}");
            }
        }
    }

    #[test]
    fn repeated_and_vanishing_eigenvalues_are_found() {
        for size in [130, 260] {
            let values: Vec<f64> = (0..size).map(|i| 1e-9 * (i / 40) as f64).collect();
            let (found, _) = symmetric_eigen(with_spectrum(&values).as_ref()).expect("finite entries");
            for (found, expected) in found.iter().zip(&values) {
                assert!((found - expected).abs() < 1e-14 * size as f64 * 1e-9, "{found:e} {expected:e}");
            }
            let zero = Mat::zeros(size, size);
            let (found, vectors) = symmetric_eigen(zero.as_ref()).expect("zero is finite");
            assert!(found.iter().all(|&value| value == 0.0));
            let identity = product(vectors.transpose(), vectors.as_ref(), Par::Seq);
            assert!((identity - Mat::<f64>::identity(size, size)).norm_max() < 1e-13);
        }
    }

    #[test]
    fn numbers_that_are_not_finite_are_refused() {
        for value in [f64::NAN, f64::INFINITY] {
            let a = Mat::from_fn(3, 3, |i, j| if i == j { 1.0 } else { value });
            assert!(symmetric_eigen(a.as_ref()).is_err());
        }
    }
}
