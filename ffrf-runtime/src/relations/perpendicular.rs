//! A direction of the first marker and one of the second stay at right angles.

use nalgebra::{RealField, Vector3};

use super::Row;
use crate::body::{MarkerMotion, Wrench};

/// u · w = 0, where u turns with the first and w with the second marker (inertial components now).
pub fn perpendicular<T: RealField + Copy>(
    first: &MarkerMotion<T>,
    second: &MarkerMotion<T>,
    u: &Vector3<T>,
    w: &Vector3<T>,
) -> Row<T> {
    let (left, right) = (&first.angular_velocity, &second.angular_velocity);
    driven(u, left, &Vector3::zeros(), w, right, T::zero())
}

/// [`perpendicular`], where u turns with `turning`, whose rate has `bias_turning` besides the first marker's ω̇.
pub(super) fn driven<T: RealField + Copy>(
    u: &Vector3<T>,
    turning: &Vector3<T>,
    bias_turning: &Vector3<T>,
    w: &Vector3<T>,
    right: &Vector3<T>,
    rate: T,
) -> Row<T> {
    // ġ = (ω_u × u) · w + u · (ω_w × w) = (ω_u - ω_w) · (u × w)
    let normal = u.cross(w);
    let change = turning.cross(u).cross(w) + u.cross(&right.cross(w));
    Row {
        residual: u.dot(w),
        first: Wrench { force: Vector3::zeros(), moment: normal },
        second: Wrench { force: Vector3::zeros(), moment: -normal },
        rate,
        bias: (turning - right).dot(&change) + bias_turning.dot(&normal),
    }
}
