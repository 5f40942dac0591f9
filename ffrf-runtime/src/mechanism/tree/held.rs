//! What rows that hold forces, or moments, leave of three components.

use nalgebra::{RealField, Vector3};

/// Up to three rows on three components: their duals, and the directions that they leave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Held<T> {
    /// For each row d with d · row = 1 that is at right angles to the other rows. As many as rows.
    pub(crate) duals: [Vector3<T>; 3],
    /// Directions at right angles to every row. Three less the rows.
    pub(crate) free: [Vector3<T>; 3],
}

impl<T: RealField + Copy> Held<T> {
    /// Of the first `count` rows; not finite if they are dependent.
    #[inline]
    pub(crate) fn by(rows: &[Vector3<T>; 3], count: usize) -> Self {
        let none = Vector3::zeros();
        let [first, second, third] = rows;
        match count {
            0 => Self::nothing(),
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
                Self { duals: [dual, none, none], free: [across, dual.cross(&across), none] }
            }
            2 => {
                let along = first.cross(second);
                let share = along * (T::one() / along.norm_squared());
                Self { duals: [second.cross(&share), share.cross(first), none], free: [along, none, none] }
            }
            _ => {
                let [across, other] = [second.cross(third), third.cross(first)];
                let share = T::one() / first.dot(&across);
                let duals = [across * share, other * share, first.cross(second) * share];
                Self { duals, free: [none; 3] }
            }
        }
    }

    /// No rows.
    pub(crate) fn nothing() -> Self {
        Self { duals: [Vector3::zeros(); 3], free: [Vector3::x(), Vector3::y(), Vector3::z()] }
    }

    /// The axes as rows.
    #[inline]
    pub(crate) fn point() -> Self {
        Self { duals: [Vector3::x(), Vector3::y(), Vector3::z()], free: [Vector3::zeros(); 3] }
    }
}
