//! A point of the second marker stays on the z axis of the first.

use nalgebra::RealField;

use super::{Rows, axes, in_plane};
use crate::body::MarkerMotion;

/// Adds the two rows x₁ · (r₂ - r₁) = 0 and y₁ · (r₂ - r₁) = 0.
pub fn in_line<T: RealField + Copy>(rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>) {
    let [x, y, _] = axes(first);
    for normal in [x, y] {
        rows.push(in_plane(first, second, &normal, &[T::zero(); 3]));
    }
}
