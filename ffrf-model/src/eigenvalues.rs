//! Eigenvalues of small symmetric matrices, for the consistency checks only.

/// Sweeps after which the iteration stops; cyclic Jacobi converges quadratically, in 6 to 10 sweeps.
const MAX_SWEEPS: usize = 40;

/// Smallest eigenvalue of a symmetric matrix by cyclic Jacobi rotations; `None` for an empty matrix.
///
/// Only the lower triangle counts. Accuracy: a few units in the last place of the largest entry.
/// Source: Golub & Van Loan, Matrix Computations, section 8.5.
pub(crate) fn smallest_eigenvalue(mut a: Vec<Vec<f64>>) -> Option<f64> {
    let n = a.len();
    for i in 0..n {
        for j in 0..i {
            a[j][i] = a[i][j];
        }
    }
    let scale = a.iter().flatten().fold(0.0_f64, |max, entry| max.max(entry.abs()));
    // Below this, what is off the diagonal moves no eigenvalue by more than a rounding of the largest.
    let negligible = f64::EPSILON * scale / (1 + n) as f64;
    for _ in 0..MAX_SWEEPS {
        let mut rotated = false;
        for p in 1..n {
            for q in 0..p {
                if a[p][q].abs() > negligible {
                    rotate(&mut a, p, q);
                    rotated = true;
                }
            }
        }
        if !rotated {
            break;
        }
    }
    (0..n).map(|i| a[i][i]).reduce(f64::min)
}

/// One Jacobi rotation that brings entry (p, q) to zero.
fn rotate(a: &mut [Vec<f64>], p: usize, q: usize) {
    let tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let tangent = tau.signum() / (tau.abs() + tau.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = tangent * cosine;
    for row in a.iter_mut() {
        let (x, y) = (row[p], row[q]);
        row[p] = cosine * x - sine * y;
        row[q] = sine * x + cosine * y;
    }
    for k in 0..a.len() {
        let (x, y) = (a[p][k], a[q][k]);
        a[p][k] = cosine * x - sine * y;
        a[q][k] = sine * x + cosine * y;
    }
}

/// Scales a symmetric matrix with non-negative diagonal to a unit diagonal; rows of zero diagonal stay.
pub(crate) fn to_unit_diagonal(mut a: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let scale: Vec<f64> =
        (0..a.len()).map(|i| if a[i][i] > 0.0 { a[i][i].sqrt().recip() } else { 1.0 }).collect();
    for i in 0..a.len() {
        for j in 0..a.len() {
            a[i][j] *= scale[i] * scale[j];
        }
    }
    a
}

/// Schur complement of the leading `count` rows and columns, by Gaussian elimination without pivoting.
///
/// `None` if a pivot is not above `floor`: the leading block is not positive definite.
pub(crate) fn schur_complement(mut a: Vec<Vec<f64>>, count: usize, floor: f64) -> Option<Vec<Vec<f64>>> {
    let n = a.len();
    for k in 0..count {
        if a[k][k].is_nan() || a[k][k] <= floor {
            return None;
        }
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            for j in k + 1..n {
                a[i][j] -= factor * a[k][j];
            }
        }
    }
    Some(a.into_iter().skip(count).map(|row| row.into_iter().skip(count).collect()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvalues_of_a_known_matrix() {
        // Second differences: eigenvalues 2 - 2 cos(k π / (n + 1)).
        let n = 12;
        let mut a = vec![vec![0.0; n]; n];
        for i in 0..n {
            a[i][i] = 2.0;
            if i > 0 {
                a[i][i - 1] = -1.0;
            }
        }
        let expected = 2.0 - 2.0 * (std::f64::consts::PI / (n + 1) as f64).cos();
        let found = smallest_eigenvalue(a).unwrap();
        assert!((found - expected).abs() < 1e-14, "{found} instead of {expected}");
    }

    #[test]
    fn an_indefinite_matrix_shows_its_negative_eigenvalue() {
        let found = smallest_eigenvalue(vec![vec![1.0, 2.0], vec![2.0, 1.0]]).unwrap();
        assert!((found + 1.0).abs() < 1e-15, "{found}");
        assert_eq!(smallest_eigenvalue(vec![]), None);
    }

    #[test]
    fn schur_complement_of_a_known_matrix() {
        let a = vec![vec![4.0, 2.0, 0.0], vec![2.0, 3.0, 1.0], vec![0.0, 1.0, 5.0]];
        assert_eq!(schur_complement(a.clone(), 1, 0.0).unwrap(), vec![vec![2.0, 1.0], vec![1.0, 5.0]]);
        assert_eq!(schur_complement(a, 1, 4.0), None);
    }
}
