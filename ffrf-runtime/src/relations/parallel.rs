//! The z axes of both triads agree.

use nalgebra::RealField;

use super::{Rows, axes, perpendicular};
use crate::body::MarkerMotion;

/// Adds the two rows z₁ · x₂ = 0 and z₁ · y₂ = 0.
pub fn parallel<T: RealField + Copy>(rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>) {
    let ([.., axis], [x, y, _]) = (axes(first), axes(second));
    rows.push(perpendicular(first, second, &axis, &x));
    rows.push(perpendicular(first, second, &axis, &y));
}
