//! A body without the entries that are zero but for round-off.

use ffrf_model::{Matrix3, ReducedBody, Vector3};

use crate::layout::{GramScales, negligible_first_moment};
use crate::options::ORTHOGONALITY_TOLERANCE;

/// The body with entries below `tolerance` times their Gram scale set to zero, as generated code takes its invariants.
///
/// The even and the odd combination of each pair of entries across the diagonal of a moment have that test each. `of_markers`: entries of
/// mode shapes at markers as well, beside the mode's root mean square over the mass (translations) and that over the radius
/// of gyration (rotations); generated bodies keep those.
pub fn significant(body: &ReducedBody, tolerance: f64, of_markers: bool) -> ReducedBody {
    let scales = GramScales::of(body);
    let small = |value: f64, scale: f64| value.abs() <= tolerance * scale;
    let kept = |value: f64, scale: f64| if small(value, scale) { 0.0 } else { value };
    let moment = |moment: &Matrix3, scale: f64| significant_moment(moment, |value| small(value, scale));
    let mut left = body.clone();
    let inertia = &mut left.inertia;
    let negligible = negligible_first_moment(body, &scales, tolerance);
    inertia.first_moment = inertia.first_moment.map(|x| if x.abs() <= negligible { 0.0 } else { x });
    inertia.second_moment = moment(&inertia.second_moment, scales.position * scales.position);
    for (mu, mode) in scales.modes.iter().enumerate() {
        if let Some(entries) = inertia.modal_first_moment.get_mut(mu) {
            *entries = entries.map(|x| kept(x, scales.translation * mode));
        }
        if let Some(entries) = inertia.position_mode_moment.get_mut(mu) {
            *entries = moment(entries, scales.position * mode);
        }
        for (entries, other) in
            inertia.mode_mode_moment.iter_mut().skip(mu).take(1).flatten().zip(&scales.modes)
        {
            *entries = moment(entries, mode * other);
        }
    }
    let orthogonal = tolerance.max(ORTHOGONALITY_TOLERANCE);
    for (matrix, scales) in [(&mut left.stiffness, &scales.stiffness), (&mut left.damping, &scales.damping)] {
        for (row, own) in matrix.iter_mut().zip(scales) {
            for (entry, other) in row.iter_mut().zip(scales) {
                if entry.abs() <= orthogonal * own * other {
                    *entry = 0.0;
                }
            }
        }
    }
    if let Some(geometric) = &mut left.geometric_stiffness {
        for entries in geometric.linear_load.iter_mut().flatten() {
            let scale = largest(entries.as_flattened());
            *entries = moment(entries, scale);
        }
        for entries in geometric.uniform_load.iter_mut().flatten() {
            let scale = largest(entries);
            *entries = entries.map(|x| kept(x, scale));
        }
    }
    if of_markers {
        let radius = scales.position / scales.translation;
        let shapes = |shapes: &mut Vec<Vector3>, unit: f64| {
            for (entries, mode) in shapes.iter_mut().zip(&scales.modes) {
                *entries = entries.map(|x| kept(x, mode / (scales.translation * unit)));
            }
        };
        for marker in &mut left.markers {
            shapes(&mut marker.translation, 1.0);
            shapes(&mut marker.rotation, radius);
        }
    }
    left
}

/// A moment in which what is negligible of the diagonal, and of even and odd combinations, is zero.
fn significant_moment(moment: &Matrix3, small: impl Fn(f64) -> bool) -> Matrix3 {
    let mut left = *moment;
    for i in 0..3 {
        if small(moment[i][i]) {
            left[i][i] = 0.0;
        }
        for j in 0..i {
            let (upper, lower) = (moment[j][i], moment[i][j]);
            let (even, odd) = (upper + lower, upper - lower);
            [left[j][i], left[i][j]] = match (small(even), small(odd)) {
                (true, true) => [0.0; 2],
                (true, false) => [0.5 * odd, -0.5 * odd],
                (false, true) => [0.5 * even; 2],
                (false, false) => [upper, lower],
            };
        }
    }
    left
}

fn largest(entries: &[f64]) -> f64 {
    entries.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_off_of_a_symmetric_moment_goes_and_what_is_odd_stays() {
        let moment = [[2.0, 1.0 + 1e-14, 1e-14], [1.0, 1e-14, 0.3], [-1e-14, -0.3 + 1e-14, 1.0]];
        let left = significant_moment(&moment, |value| value.abs() <= 1e-12);
        assert_eq!(left[0][1], left[1][0]);
        assert_eq!(left[1][2], -left[2][1]);
        assert_eq!([left[0][0], left[1][1], left[0][2], left[2][0]], [2.0, 0.0, 0.0, 0.0]);
        assert_eq!(significant_moment(&moment, |_| false), moment);
    }
}
