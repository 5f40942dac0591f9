//! Signs of indefiniteness in matrices too large to factorise a second time.
//!
//! Both tests are proofs when they find something (a vector x with xᵀ A x < 0), but finding nothing proves
//! nothing: the factorisation and Sturm count of the mode computation decide.

use faer::{Mat, Side};

use crate::SparseMatrix;

/// Lanczos steps. After k steps an eigenvalue that stands out of a spectrum of n by (ln n / 2k)², about one
/// percent of its width for n = 100,000, has been found (Saad, "Numerical Methods for Large Eigenvalue Problems", 6.6).
const STEPS: usize = 60;

/// A lowest value xᵀ A x / xᵀ D x found, with D the diagonal, and the row where x is largest.
pub(super) struct Witness {
    pub(super) row: usize,
    pub(super) value: f64,
}

/// Looks for the lowest 2 x 2 principal minor of a matrix that is scaled to unit diagonal; `lower` holds its lower
/// triangle. For unit diagonal the lower eigenvalue of a minor is 1 - |a_ij|.
pub(super) fn lowest_minor(lower: &SparseMatrix) -> Witness {
    let diagonal = |index: usize| lower.get(index, index).copied().unwrap_or(0.0);
    let mut lowest = Witness { row: 0, value: f64::INFINITY };
    for column in 0..lower.ncols() {
        for (row, &entry) in lower.row_idx_of_col(column).zip(lower.val_of_col(column)) {
            let value = if row == column {
                entry
            } else {
                let (a, b) = (diagonal(row), diagonal(column));
                0.5 * (a + b) - (0.25 * (a - b) * (a - b) + entry * entry).sqrt()
            };
            if value < lowest.value {
                lowest = Witness { row, value };
            }
        }
    }
    lowest
}

/// The lowest Ritz value after some Lanczos steps from a fixed start vector.
pub(super) fn lowest_ritz_value(lower: &SparseMatrix) -> Option<f64> {
    let size = lower.nrows();
    let mut vector: Vec<f64> = pseudo_random(size);
    let mut before = vec![0.0; size];
    let (mut diagonal, mut off) = (Vec::new(), Vec::new());
    let mut norm = length(&vector);
    for _ in 0..STEPS.min(size) {
        if norm <= f64::MIN_POSITIVE {
            break;
        }
        vector.iter_mut().for_each(|value| *value /= norm);
        let mut next = product(lower, &vector);
        let along: f64 = next.iter().zip(&vector).map(|(a, b)| a * b).sum();
        let back = off.last().copied().unwrap_or(0.0);
        for ((value, &current), &previous) in next.iter_mut().zip(&vector).zip(&before) {
            *value -= along * current + back * previous;
        }
        diagonal.push(along);
        norm = length(&next);
        off.push(norm);
        before = std::mem::replace(&mut vector, next);
    }
    let projected = Mat::from_fn(diagonal.len(), diagonal.len(), |row, column| match row.abs_diff(column) {
        0 => diagonal[row],
        1 => off[row.min(column)],
        _ => 0.0,
    });
    projected.self_adjoint_eigenvalues(Side::Lower).ok()?.into_iter().min_by(f64::total_cmp)
}

/// A x from the lower triangle of A.
fn product(lower: &SparseMatrix, x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; x.len()];
    for column in 0..lower.ncols() {
        let mut sum = 0.0;
        for (row, &entry) in lower.row_idx_of_col(column).zip(lower.val_of_col(column)) {
            y[row] += entry * x[column];
            if row != column {
                sum += entry * x[row];
            }
        }
        y[column] += sum;
    }
    y
}

fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|value| value * value).sum::<f64>().sqrt()
}

/// Numbers between -1 and 1 that are the same in every run (xorshift64, Marsaglia 2003).
fn pseudo_random(size: usize) -> Vec<f64> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let draw = |_| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    (0..size).map(draw).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::sparse::Triplet;

    /// Lower triangle of a chain with unit diagonal and off-diagonal -1/2, whose eigenvalues lie in (0, 2).
    fn chain(size: usize, changed: Option<(usize, usize, f64)>) -> SparseMatrix {
        let mut triplets = Vec::new();
        for k in 0..size {
            triplets.push(Triplet::new(k, k, 1.0));
            if k > 0 {
                triplets.push(Triplet::new(k, k - 1, -0.5));
            }
        }
        triplets.extend(changed.map(|(row, column, value)| Triplet::new(row, column, value)));
        SparseMatrix::try_new_from_triplets(size, size, &triplets).unwrap()
    }

    #[test]
    fn a_sound_matrix_gives_no_witness_and_a_wrong_one_does() {
        let sound = chain(5000, None);
        assert!(lowest_minor(&sound).value >= 0.5);
        assert!(lowest_ritz_value(&sound).unwrap() > 0.0);
        let pair = chain(5000, Some((4000, 17, 1.5)));
        let witness = lowest_minor(&pair);
        assert_eq!((witness.row, witness.value), (4000, -0.5));
        // each 2 x 2 minor is sound, the 3 x 3 minor of rows 998 to 1000 is not
        let triple = chain(5000, Some((1000, 998, -0.9)));
        assert!(lowest_minor(&triple).value > 0.0);
        assert!(lowest_ritz_value(&triple).unwrap() < -0.1);
    }
}
