//! Extreme eigenvalues of symmetric matrices, and the eliminations around them: for checks and frequencies only.

/// Halvings of the interval that holds all eigenvalues: to the spacing of its floating-point numbers and below.
const HALVINGS: usize = 64;

/// Smallest eigenvalue of a symmetric matrix; `None` for an empty matrix, not-a-number if an entry is not finite.
///
/// Only the lower triangle counts. Accuracy: a few units in the last place of the largest entry.
/// Source: Golub & Van Loan, Matrix Computations, sections 8.3 (tridiagonal form) and 8.4 (bisection).
pub(crate) fn smallest_eigenvalue(a: Vec<Vec<f64>>) -> Option<f64> {
    extreme_eigenvalue(a, |below, _| below > 0)
}

/// Largest eigenvalue of a symmetric matrix, as [`smallest_eigenvalue`].
pub(crate) fn largest_eigenvalue(a: Vec<Vec<f64>>) -> Option<f64> {
    extreme_eigenvalue(a, |below, n| below == n)
}

/// Bisection: `lower` says whether the eigenvalue lies below a number that has `below` of `n` eigenvalues below it.
fn extreme_eigenvalue(a: Vec<Vec<f64>>, lower: fn(usize, usize) -> bool) -> Option<f64> {
    let n = a.len();
    if n == 0 {
        return None;
    }
    let Tridiagonal { diagonal, beside } = tridiagonal(a);
    // Gershgorin: every eigenvalue lies within the sum of the magnitudes of some row.
    let radius = (0..n).fold(0.0_f64, |radius, i| {
        let left = if i > 0 { beside[i - 1].abs() } else { 0.0 };
        let row = diagonal[i].abs() + left + beside[i].abs();
        if row.is_nan() { f64::NAN } else { radius.max(row) }
    });
    if !radius.is_finite() || diagonal.iter().chain(&beside).any(|entry| !entry.is_finite()) {
        return Some(f64::NAN);
    }
    let (mut low, mut high) = (-radius, radius);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if lower(count_below(&diagonal, &beside, middle), n) {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(0.5 * (low + high))
}

/// A symmetric tridiagonal matrix; `beside[i]` is entry (i, i + 1), the last one zero.
struct Tridiagonal {
    diagonal: Vec<f64>,
    beside: Vec<f64>,
}

/// Tridiagonal form by Householder reflections, from the last row upwards; reads the lower triangle.
fn tridiagonal(mut a: Vec<Vec<f64>>) -> Tridiagonal {
    let n = a.len();
    let mut beside = vec![0.0; n];
    for k in (1..n).rev() {
        // Reflect the first k entries of row k onto the last of them.
        let scale = a[k][..k].iter().fold(0.0_f64, |max, entry| max.max(entry.abs()));
        let off_line = a[k][..k - 1].iter().any(|entry| *entry != 0.0);
        if !off_line || scale == 0.0 {
            beside[k - 1] = a[k][k - 1];
            continue;
        }
        let mut v: Vec<f64> = a[k][..k].iter().map(|entry| entry / scale).collect();
        let norm = v.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        let signed = norm.copysign(v[k - 1]);
        beside[k - 1] = -scale * signed;
        // v = x + signed e, and vᵀv / 2 = norm (norm + |x_last|).
        let half_square = norm * (norm + v[k - 1].abs());
        v[k - 1] += signed;
        // p = A v / (vᵀv / 2), w = p - v (vᵀp) / (vᵀv), A := A - v wᵀ - w vᵀ.
        let mut w = vec![0.0; k];
        for i in 0..k {
            for j in 0..i {
                w[i] += a[i][j] * v[j];
                w[j] += a[i][j] * v[i];
            }
            w[i] += a[i][i] * v[i];
        }
        let along = w.iter().zip(&v).map(|(w, v)| w * v).sum::<f64>() / half_square;
        for (w, v) in w.iter_mut().zip(&v) {
            *w = (*w - 0.5 * along * v) / half_square;
        }
        for i in 0..k {
            for j in 0..=i {
                a[i][j] -= v[i] * w[j] + w[i] * v[j];
            }
        }
    }
    Tridiagonal { diagonal: (0..n).map(|i| a[i][i]).collect(), beside }
}

/// Number of eigenvalues below `limit`: negative pivots of T - limit I (Sylvester's law of inertia).
fn count_below(diagonal: &[f64], beside: &[f64], limit: f64) -> usize {
    let mut count = 0;
    let mut pivot = 1.0_f64;
    for (i, entry) in diagonal.iter().enumerate() {
        let before = if i > 0 { beside[i - 1] } else { 0.0 };
        // beside / pivot first: the square could overflow.
        pivot = entry - limit - before * (before / pivot);
        if pivot == 0.0 {
            pivot = -f64::MIN_POSITIVE;
        }
        if pivot < 0.0 {
            count += 1;
        }
    }
    count
}

/// Scales a symmetric matrix with non-negative diagonal to a unit diagonal; rows of zero diagonal stay.
///
/// The factors come with it: entry (i, j) was multiplied by those of i and j.
pub(crate) fn to_unit_diagonal(mut a: Vec<Vec<f64>>) -> (Vec<Vec<f64>>, Vec<f64>) {
    let scale: Vec<f64> =
        (0..a.len()).map(|i| if a[i][i] > 0.0 { a[i][i].sqrt().recip() } else { 1.0 }).collect();
    for i in 0..a.len() {
        for j in 0..a.len() {
            a[i][j] *= scale[i] * scale[j];
        }
    }
    (a, scale)
}

/// Schur complement of the leading `count` rows and columns, by Gaussian elimination without pivoting.
///
/// `None` if a pivot is not above `floor`: the leading block is not positive definite.
pub(crate) fn schur_complement(mut a: Vec<Vec<f64>>, count: usize, floor: f64) -> Option<Vec<Vec<f64>>> {
    for k in 0..count {
        if a[k][k].is_nan() || a[k][k] <= floor {
            return None;
        }
        eliminate(&mut a, k);
    }
    Some(a.into_iter().skip(count).map(|row| row.into_iter().skip(count).collect()).collect())
}

/// Subtracts from all rows below `k` the multiple of row `k` that clears their entry in column `k`.
pub(crate) fn eliminate(a: &mut [Vec<f64>], k: usize) {
    let (above, below) = a.split_at_mut(k + 1);
    let Some(pivot_row) = above.last() else { return };
    for row in below {
        let factor = row[k] / pivot_row[k];
        for (entry, pivot) in row.iter_mut().zip(pivot_row).skip(k + 1) {
            *entry -= factor * pivot;
        }
    }
}

/// Lower Cholesky factor L of a symmetric matrix, L Lᵀ = A; `None` if A is not positive definite.
///
/// Only the lower triangle counts.
pub(crate) fn cholesky(mut a: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
    let n = a.len();
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| a[i][k] * a[j][k]).sum();
            let left = a[i][j] - sum;
            if i == j {
                // Not-a-number is no positive pivot either.
                if !(left > 0.0 && left.is_finite()) {
                    return None;
                }
                a[i][i] = left.sqrt();
            } else {
                a[i][j] = left / a[j][j];
            }
        }
        a[i][i + 1..].fill(0.0);
    }
    Some(a)
}

/// L⁻¹ A L⁻ᵀ for a symmetric A and a lower triangular L of the same size.
pub(crate) fn congruent(factor: &[Vec<f64>], a: &[Vec<f64>]) -> Vec<Vec<f64>> {
    // Solving L X = A for the columns, then L Y = Xᵀ.
    let once = solve_columns(factor, a);
    solve_columns(factor, &transposed(&once))
}

fn solve_columns(factor: &[Vec<f64>], a: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut solved: Vec<Vec<f64>> = Vec::with_capacity(a.len());
    for (row, coefficients) in a.iter().zip(factor) {
        let mut row = row.clone();
        for (earlier, coefficient) in solved.iter().zip(coefficients) {
            for (entry, other) in row.iter_mut().zip(earlier) {
                *entry -= coefficient * other;
            }
        }
        let pivot = coefficients[solved.len()];
        row.iter_mut().for_each(|entry| *entry /= pivot);
        solved.push(row);
    }
    solved
}

fn transposed(a: &[Vec<f64>]) -> Vec<Vec<f64>> {
    (0..a.len()).map(|i| a.iter().map(|row| row[i]).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Second differences: eigenvalues 2 - 2 cos(k π / (n + 1)).
    fn second_differences(n: usize) -> Vec<Vec<f64>> {
        let entry = |i: usize, j: usize| match i.abs_diff(j) {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        };
        (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
    }

    /// H A H for the reflection H = I - 2 u uᵀ / uᵀu: full, with the same eigenvalues.
    fn reflected(a: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        let n = a.len();
        let u: Vec<f64> = (0..n).map(|i| 1.0 + (i * i % 5) as f64).collect();
        let square: f64 = u.iter().map(|entry| entry * entry).sum();
        let h: Vec<Vec<f64>> = (0..n)
            .map(|i| (0..n).map(|j| f64::from(i == j) - 2.0 * u[i] * u[j] / square).collect())
            .collect();
        let product = |a: &[Vec<f64>], b: &[Vec<f64>]| -> Vec<Vec<f64>> {
            (0..n).map(|i| (0..n).map(|j| (0..n).map(|k| a[i][k] * b[k][j]).sum()).collect()).collect()
        };
        product(&product(&h, &a), &h)
    }

    #[test]
    fn eigenvalues_of_a_known_matrix() {
        for n in [1, 2, 3, 12, 40] {
            let angle = std::f64::consts::PI / (n + 1) as f64;
            for a in [second_differences(n), reflected(second_differences(n))] {
                let cases = [
                    (smallest_eigenvalue(a.clone()).unwrap(), 2.0 - 2.0 * angle.cos()),
                    (largest_eigenvalue(a).unwrap(), 2.0 + 2.0 * angle.cos()),
                ];
                for (found, expected) in cases {
                    // A few units in the last place of the norm 4, more with the size.
                    assert!((found - expected).abs() < 2e-15 * (4 + n) as f64, "{n}: {found}, {expected}");
                }
            }
        }
    }

    #[test]
    fn an_indefinite_matrix_shows_its_negative_eigenvalue() {
        let found = smallest_eigenvalue(vec![vec![1.0, 2.0], vec![2.0, 1.0]]).unwrap();
        assert!((found + 1.0).abs() < 1e-15, "{found}");
        assert_eq!(smallest_eigenvalue(vec![]), None);
        assert_eq!(smallest_eigenvalue(vec![vec![0.0; 3]; 3]), Some(0.0));
    }

    #[test]
    fn what_is_not_finite_is_not_a_number() {
        for bad in [f64::NAN, f64::INFINITY] {
            for (i, j) in [(0, 0), (2, 1), (2, 0), (2, 2)] {
                let mut a = second_differences(3);
                a[i][j] = bad;
                assert!(smallest_eigenvalue(a).unwrap().is_nan(), "({i}, {j}) {bad}");
            }
        }
    }

    #[test]
    fn schur_complement_of_a_known_matrix() {
        let a = vec![vec![4.0, 2.0, 0.0], vec![2.0, 3.0, 1.0], vec![0.0, 1.0, 5.0]];
        assert_eq!(schur_complement(a.clone(), 1, 0.0).unwrap(), vec![vec![2.0, 1.0], vec![1.0, 5.0]]);
        assert_eq!(schur_complement(a, 1, 4.0), None);
    }

    #[test]
    fn cholesky_of_a_known_matrix_and_its_congruence() {
        let a = vec![vec![4.0, 2.0], vec![2.0, 5.0]];
        let factor = cholesky(a.clone()).unwrap();
        assert_eq!(factor, vec![vec![2.0, 0.0], vec![1.0, 2.0]]);
        assert_eq!(congruent(&factor, &a), vec![vec![1.0, 0.0], vec![0.0, 1.0]]);
        assert_eq!(cholesky(vec![vec![1.0, 2.0], vec![2.0, 1.0]]), None);
        assert_eq!(cholesky(vec![vec![f64::NAN]]), None);
    }
}
