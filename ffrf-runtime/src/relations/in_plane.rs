//! A point of the second marker stays in a plane of the first, or travels along its normal as given.

use nalgebra::{RealField, Vector3};

use super::Row;
use crate::body::{MarkerMotion, Wrench};

/// n · (r₂ - r₁) = travel, where `normal` n (inertial components now) turns with the first marker.
///
/// `travel`: value, rate and acceleration. Units: m, m/s, m/s².
pub fn in_plane<T: RealField + Copy>(
    first: &MarkerMotion<T>,
    second: &MarkerMotion<T>,
    normal: &Vector3<T>,
    travel: &[T; 3],
) -> Row<T> {
    let two: T = nalgebra::convert(2.0);
    let [value, rate, acceleration] = *travel;
    let omega = &first.angular_velocity;
    let distance = second.position - first.position;
    let velocity = second.velocity - first.velocity;
    // ġ = n · ḋ + (ω × n) · d
    let turning = omega.cross(normal);
    Row {
        residual: normal.dot(&distance) - value,
        first: Wrench { force: -normal, moment: normal.cross(&distance) },
        second: Wrench { force: *normal, moment: Vector3::zeros() },
        rate: -rate,
        bias: turning.dot(&velocity) * two + omega.cross(&turning).dot(&distance) - acceleration,
    }
}
