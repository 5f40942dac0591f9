//! Eigenvalues of small symmetric matrices, finished by Jacobi rotations.
//!
//! Measured with faer 0.24: on matrices of about a hundred rows with eigenvalues in tight groups the dense solver can
//! leave 1e-4 of the norm off the diagonal of VᵀAV. Rotations of the pairs that are left bring it to round-off, and
//! where nothing is left they cost one product.

use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Mat, MatRef, Par};

use crate::modes::{ModeError, cholesky, gram, product, symmetric_eigen, symmetrised};

/// Sweeps after which the rotations end; they converge quadratically, and start close.
const SWEEPS: usize = 12;

/// Eigenvalues in ascending order and orthonormal eigenvectors (lower triangle read).
///
/// Errors: [`ModeError::EigenvaluesNotFound`].
pub(crate) fn eigen(a: MatRef<'_, f64>) -> Result<(Vec<f64>, Mat<f64>), ModeError> {
    let size = a.nrows();
    let whole = Mat::from_fn(size, size, |i, j| if i >= j { a[(i, j)] } else { a[(j, i)] });
    let (_, mut vectors) = symmetric_eigen(whole.as_ref())?;
    let image = product(whole.as_ref(), vectors.as_ref(), Par::Seq);
    let mut rest = symmetrised(gram(vectors.as_ref(), image.as_ref(), Par::Seq).as_ref());
    let round_off = f64::EPSILON * (0..size).fold(0.0_f64, |max, i| max.max(rest[(i, i)].abs()));
    for _ in 0..SWEEPS {
        let mut rotated = false;
        for j in 1..size {
            for i in 0..j {
                if rest[(i, j)].abs() > round_off {
                    rotate(&mut rest, &mut vectors, i, j);
                    rotated = true;
                }
            }
        }
        if !rotated {
            break;
        }
    }
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|&i, &j| rest[(i, i)].total_cmp(&rest[(j, j)]));
    let values = order.iter().map(|&k| rest[(k, k)]).collect();
    Ok((values, Mat::from_fn(size, size, |i, j| vectors[(i, order[j])])))
}

/// Makes the entry (i, j) zero.
fn rotate(matrix: &mut Mat<f64>, vectors: &mut Mat<f64>, i: usize, j: usize) {
    let off = matrix[(i, j)];
    let ratio = (matrix[(j, j)] - matrix[(i, i)]) / (2.0 * off);
    // The smaller of the two angles; signum is 1 at 0.
    let tangent = ratio.signum() / (ratio.abs() + ratio.hypot(1.0));
    let cosine = tangent.hypot(1.0).recip();
    let sine = tangent * cosine;
    for matrix in [&mut *matrix, vectors] {
        for k in 0..matrix.nrows() {
            let (x, y) = (matrix[(k, i)], matrix[(k, j)]);
            matrix[(k, i)] = cosine * x - sine * y;
            matrix[(k, j)] = sine * x + cosine * y;
        }
    }
    for k in 0..matrix.ncols() {
        let (x, y) = (matrix[(i, k)], matrix[(j, k)]);
        matrix[(i, k)] = cosine * x - sine * y;
        matrix[(j, k)] = sine * x + cosine * y;
    }
    matrix[(i, j)] = 0.0;
    matrix[(j, i)] = 0.0;
}

/// Pairs of K y = λ M y: λ ascending, YᵀMY = I.
///
/// Errors: [`ModeError::NotPositiveDefinite`] if M is not positive definite.
pub(crate) fn generalised(
    stiffness: MatRef<'_, f64>,
    mass: MatRef<'_, f64>,
) -> Result<(Vec<f64>, Mat<f64>), ModeError> {
    let lower = cholesky(mass, "the modal mass matrix")?;
    let (values, mut vectors) = eigen(congruent(lower.as_ref(), stiffness).as_ref())?;
    solve_upper_triangular_in_place(lower.transpose(), vectors.as_mut(), Par::Seq);
    Ok((values, vectors))
}

/// L⁻¹ A L⁻ᵀ, symmetric to the bit.
pub(crate) fn congruent(lower: MatRef<'_, f64>, a: MatRef<'_, f64>) -> Mat<f64> {
    let mut reduced = a.to_owned();
    for _ in 0..2 {
        solve_lower_triangular_in_place(lower, reduced.as_mut(), Par::Seq);
        reduced = reduced.transpose().to_owned();
    }
    symmetrised(reduced.as_ref())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tight_groups_are_separated_to_round_off() {
        // Groups of four eigenvalues that differ in the tenth digit, turned by reflections.
        let size = 96;
        let value = |i: usize| (1.0 + (i / 4) as f64).powi(3) * (1.0 + 1e-10 * (i % 4) as f64);
        let mut a = Mat::from_fn(size, size, |i, j| if i == j { value(i) } else { 0.0 });
        for turn in 0..3 {
            let v: Vec<f64> = (0..size).map(|i| ((turn + 2) as f64 * (i + 1) as f64).sin()).collect();
            let square: f64 = v.iter().map(|x| x * x).sum();
            let reflection =
                Mat::from_fn(size, size, |i, j| if i == j { 1.0 } else { 0.0 } - 2.0 * v[i] * v[j] / square);
            a = &reflection * &a * &reflection;
        }
        let a = symmetrised(a.as_ref());
        let (values, vectors) = eigen(a.as_ref()).expect("finite numbers");
        let norm = value(size - 1);
        let residual = &a * &vectors - Mat::from_fn(size, size, |i, j| vectors[(i, j)] * values[j]);
        assert!(residual.norm_max() < 1e-13 * norm, "{:e}", residual.norm_max());
        let orthogonality = vectors.transpose() * &vectors - Mat::<f64>::identity(size, size);
        assert!(orthogonality.norm_max() < 1e-13, "{:e}", orthogonality.norm_max());
        for (i, found) in values.iter().enumerate() {
            assert!((found - value(i)).abs() < 1e-13 * norm, "{found}, expected {}", value(i));
        }
    }
}
