//! One definite choice of order, of signs, and of the basis within repeated eigenvalues.

use faer::Mat;

use super::ModeError;
use super::block::rotate;
use super::problem::Problem;
use super::symmetric_eigen::symmetric_eigen;

/// Relative distance below which neighbouring eigenvalues count as one repeated eigenvalue.
///
/// Above the solver's accuracy (about 1e-12), below what meshes make of a symmetry that they break.
pub(crate) const REPEATED: f64 = 1e-8;

/// Rotates the modes of each repeated eigenvalue so that they follow the coordinate directions.
///
/// Within a cluster the functional Σ (i + 1) |φ^i|² over all degrees of freedom is made diagonal: of the two
/// bending modes of a square beam along x, the first then bends along y and the second along z. What that
/// leaves undetermined is settled by a second functional that weighs nodes by a wave across the part.
pub(crate) fn settle_repeated(
    problem: &Problem<'_>,
    values: &[f64],
    shapes: &mut Mat<f64>,
) -> Result<(), ModeError> {
    for (start, end) in clusters(values, REPEATED) {
        rotate_cluster(problem, shapes, start, end)?;
    }
    Ok(())
}

fn rotate_cluster(
    problem: &Problem<'_>,
    shapes: &mut Mat<f64>,
    start: usize,
    end: usize,
) -> Result<(), ModeError> {
    let direction_weight = |dof: usize| (dof % 3 + 1) as f64;
    let measured = diagonalise(problem, shapes, start, end, direction_weight)?;
    for (first, last) in clusters(&measured, 1e-6) {
        diagonalise(problem, shapes, start + first, start + last, |dof| wave_weight(problem, dof))?;
    }
    Ok(())
}

/// A weight without any symmetry that a part may have: sine of a skew plane wave.
fn wave_weight(problem: &Problem<'_>, dof: usize) -> f64 {
    let positions = &problem.model.nodes.positions;
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
    for &value in positions.iter().flatten() {
        low = low.min(value);
        high = high.max(value);
    }
    let size = (high - low).max(f64::MIN_POSITIVE);
    let x = positions[dof / 3].map(|value| (value - low) / size);
    (2.1 * x[0] + 3.3 * x[1] + 4.7 * x[2] + 0.3 * (dof % 3) as f64).sin()
}

/// Makes Φᵀ diag(weight) Φ diagonal on columns `start..end`; returns its normalised diagonal, ascending.
fn diagonalise(
    problem: &Problem<'_>,
    shapes: &mut Mat<f64>,
    start: usize,
    end: usize,
    weight: impl Fn(usize) -> f64,
) -> Result<Vec<f64>, ModeError> {
    let size = end - start;
    let weights: Vec<f64> = problem.free.iter().map(|&dof| weight(dof)).collect();
    let mut functional = Mat::zeros(size, size);
    let mut total = 0.0;
    for a in 0..size {
        let left = shapes.col_as_slice(start + a);
        total += left.iter().map(|x| x * x).sum::<f64>();
        for b in 0..=a {
            let right = shapes.col_as_slice(start + b);
            let value: f64 = (0..weights.len()).map(|i| weights[i] * left[i] * right[i]).sum();
            functional[(a, b)] = value;
            functional[(b, a)] = value;
        }
    }
    let (values, rotation) = symmetric_eigen(functional.as_ref())?;
    rotate(shapes.as_mut().get_mut(.., start..end), rotation.as_ref(), problem.threads);
    let scale = if total > 0.0 { size as f64 / total } else { 1.0 };
    Ok(values.into_iter().map(|value| value * scale).collect())
}

/// Ranges of at least two neighbours closer than `tolerance` relative to the larger.
fn clusters(values: &[f64], tolerance: f64) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut start = 0;
    for end in 1..=values.len() {
        let joined = end < values.len()
            && (values[end] - values[end - 1]).abs()
                <= tolerance * values[end].abs().max(values[end - 1].abs());
        if !joined {
            if end - start > 1 {
                found.push((start, end));
            }
            start = end;
        }
    }
    found
}

/// Makes the largest entry of each column positive; among entries that tie, the first decides.
pub(crate) fn settle_signs(shapes: &mut Mat<f64>) {
    /// Entries within this of the largest tie: symmetric shapes repeat their largest entry up to round-off.
    const TIE: f64 = 1.0 - 1e-6;
    for j in 0..shapes.ncols() {
        let column = shapes.col_as_slice_mut(j);
        let largest = column.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        if column.iter().find(|x| x.abs() >= TIE * largest).is_some_and(|x| *x < 0.0) {
            column.iter_mut().for_each(|x| *x = -*x);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clusters_join_neighbours_only() {
        assert_eq!(clusters(&[1.0, 1.0 + 1e-10, 2.0, 3.0, 3.0, 3.0], 1e-8), vec![(0, 2), (3, 6)]);
        assert!(clusters(&[1.0, 2.0], 1e-8).is_empty());
    }

    #[test]
    fn the_first_of_tying_entries_decides_the_sign() {
        let mut shapes = Mat::from_fn(3, 1, |i, _| [0.5, -1.0, 1.0 + 1e-12][i]);
        settle_signs(&mut shapes);
        assert_eq!(shapes[(1, 0)], 1.0);
    }
}
