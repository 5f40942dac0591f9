//! Counting eigenvalues below a shift, so that no mode is missed silently (Sturm count).

use faer::Par;

use super::ModeError;
use super::factor::Analysis;
use super::problem::Problem;

/// Number of eigenvalues of K φ = λ M φ below `shift`, rigid-body modes included.
///
/// By Sylvester's law of inertia this is the number of negative pivots of K - shift M = L D Lᵀ.
pub(crate) fn eigenvalues_below(
    problem: &Problem<'_>,
    analysis: &Analysis,
    shift: f64,
    par: Par,
) -> Result<usize, ModeError> {
    analysis.negative_pivots(&problem.shifted_lower(shift)?, par)
}

/// Where to count, given eigenvalues in ascending order of which the first `wanted` are to be returned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CountingShift {
    /// The shift, in the middle of a gap. Units: (rad/s)².
    pub shift: f64,
    /// How many of the given eigenvalues lie below.
    pub below: usize,
}

/// Relative distance that two neighbouring eigenvalues must keep for a shift to be put between them.
const CLEAR_GAP: f64 = 1e-4;

/// The first clear gap at or after the last wanted eigenvalue; `None` if more eigenvalues are needed to tell.
pub(crate) fn counting_shift(
    values: &[f64],
    wanted: usize,
    complete: bool,
    scale: f64,
) -> Option<CountingShift> {
    for below in wanted.max(1)..=values.len() {
        let last = values[below - 1].max(0.0);
        match values.get(below) {
            Some(&next) if next - last > CLEAR_GAP * next => {
                return Some(CountingShift { shift: 0.5 * (last + next), below });
            }
            None if complete => return Some(CountingShift { shift: 1.5 * last + 0.1 * scale, below }),
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shift_stands_in_the_first_clear_gap_behind_a_pair() {
        let values = [1.0, 2.0, 2.0 + 1e-9, 5.0];
        let found = counting_shift(&values, 2, false, 1.0).expect("there is a gap before 5");
        assert_eq!(found.below, 3);
        assert!((found.shift - 3.5).abs() < 1e-8, "shift {}", found.shift);
    }

    #[test]
    fn more_values_are_asked_for_when_the_last_pair_may_be_cut() {
        assert_eq!(counting_shift(&[1.0, 2.0, 2.0 + 1e-9], 2, false, 1.0), None);
        assert!(counting_shift(&[1.0, 2.0, 2.0 + 1e-9], 2, true, 1.0).is_some());
    }
}
