//! Positive definiteness by elimination.

/// The first pivot of L D Lᵀ that is not above `limit(k)` times the entry a_kk on the diagonal: its k, and its share
/// of a_kk, or a_kk itself if that is not positive.
///
/// These shares are the pivots of the matrix scaled to a unit diagonal; units of its rows do not matter.
/// Shape: R x R, symmetric, the lower triangle is read.
pub(super) fn first_bad_pivot<const R: usize>(
    mut matrix: [[f64; R]; R],
    limit: impl Fn(usize) -> f64,
) -> Option<(usize, f64)> {
    let mut diagonal = [0.0; R];
    for k in 0..R {
        diagonal[k] = matrix[k][k];
    }
    for k in 0..R {
        let pivot = matrix[k][k];
        let share = if diagonal[k] > 0.0 { pivot / diagonal[k] } else { diagonal[k] };
        let good = diagonal[k] > 0.0 && share > limit(k);
        if !good {
            return Some((k, share));
        }
        for i in k + 1..R {
            let factor = matrix[i][k] / pivot;
            for j in k + 1..=i {
                matrix[i][j] -= factor * matrix[j][k];
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_bad_pivot_is_found_with_its_size() {
        let none = |_| 0.0;
        assert_eq!(first_bad_pivot([[4.0, 2.0], [2.0, 3.0]], none), None);
        assert_eq!(first_bad_pivot([[4.0, 2.0], [2.0, 1.0]], none), Some((1, 0.0)));
        // 2 - 4² / 4 = -2, over 2.
        assert_eq!(first_bad_pivot([[4.0, 4.0], [4.0, 2.0]], none), Some((1, -1.0)));
        assert_eq!(first_bad_pivot([[4.0, 0.0], [0.0, -3.0]], none), Some((1, -3.0)));
        assert_eq!(first_bad_pivot([[4.0, 2.0], [2.0, 3.0]], |_| 0.7), Some((1, 2.0 / 3.0)));
        assert_eq!(first_bad_pivot([[f64::NAN]], none).map(|(k, _)| k), Some(0));
        assert_eq!(first_bad_pivot([[0.0; 0]; 0], none), None);
    }
}
