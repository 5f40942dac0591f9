//! Counting eigenvalues below a shift, so that no mode is missed silently (Sturm count).

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
) -> Result<usize, ModeError> {
    analysis.negative_pivots(&problem.shifted_lower(shift)?)
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
    use std::f64::consts::TAU;

    use super::super::ordering::order;
    use super::super::{ModeRequest, Support, compute_modes};
    use super::*;
    use crate::elements::{Material, brick};

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

    #[test]
    fn a_missing_mode_is_noticed() {
        let model = brick([0.3, 0.2, 0.1], [3, 2, 2], &Material::STEEL).expect("a sound brick");
        let problem = Problem::new(&model, &Support::FreeFree, 1).expect("a free brick");
        let solution = compute_modes(&model, &ModeRequest::free_free(10), &mut |_| {}).expect("ten modes");
        let mut values: Vec<f64> = solution
            .report
            .modes
            .iter()
            .map(|mode| (TAU * mode.frequency_hz.expect("eigenmodes have frequencies")).powi(2))
            .collect();
        let lower = problem.shifted_lower(-values[0]).expect("sorted columns");
        let node_of: Vec<usize> = problem.free.iter().map(|dof| dof / 3).collect();
        let ordering = order(&lower, &node_of, &model.nodes.positions).expect("a small factor");
        let analysis = Analysis::new(&lower, &ordering.order).expect("a small factor");
        let count = |values: &[f64]| {
            let limit = counting_shift(values, 5, false, values[0]).expect("a gap before the last");
            let counted = eigenvalues_below(&problem, &analysis, limit.shift).expect("no zero pivot");
            (limit.below + solution.report.rigid_modes.len(), counted)
        };
        let (found, counted) = count(&values);
        assert_eq!(found, counted);
        values.remove(3);
        let (found, counted) = count(&values);
        assert_eq!(found + 1, counted);
    }
}
