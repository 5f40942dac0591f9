//! What rows that hold forces, or moments, leave of three components.

use nalgebra::{RealField, Vector3};

/// Finds what up to three rows on three components hold and leave.
///
/// For each row the dual d with d · row = 1 that is at right angles to the other rows, in `duals`; each direction at right angles
/// to every row, to `leave`. Whether the rows are independent.
// straight to where they stay: what is made elsewhere and copied in wider pieces waits for its stores
#[inline(always)]
pub(crate) fn hold<T: RealField + Copy>(
    rows: &[Vector3<T>; 3],
    count: usize,
    duals: &mut [Vector3<T>; 3],
    mut leave: impl FnMut(&Vector3<T>),
) -> bool {
    let [first, second, third] = rows;
    match count {
        0 => {
            for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
                leave(&axis);
            }
            true
        }
        1 => {
            // the axis that is farthest from the row
            let size = first.abs();
            let axis = match (size.x <= size.y, size.y <= size.z, size.x <= size.z) {
                (true, _, true) => Vector3::x(),
                (_, true, _) => Vector3::y(),
                _ => Vector3::z(),
            };
            let across = first.cross(&axis);
            let dual = first * (T::one() / first.norm_squared());
            duals[0] = dual;
            leave(&across);
            leave(&dual.cross(&across));
            dual.sum().is_finite()
        }
        2 => {
            let along = first.cross(second);
            let share = along * (T::one() / along.norm_squared());
            let [dual, other] = [second.cross(&share), share.cross(first)];
            [duals[0], duals[1]] = [dual, other];
            leave(&along);
            (dual + other).sum().is_finite()
        }
        _ => {
            let [across, other] = [second.cross(third), third.cross(first)];
            let share = T::one() / first.dot(&across);
            let [dual, next, last] = [across * share, other * share, first.cross(second) * share];
            [duals[0], duals[1], duals[2]] = [dual, next, last];
            (dual + next + last).sum().is_finite()
        }
    }
}
