//! The second marker is turned about the z axis of the first by a given angle.

use nalgebra::RealField;

use super::Row;
use super::perpendicular::driven;
use super::row::axes;
use crate::body::MarkerMotion;

/// sin(θ - φ) = 0, where θ is the angle from x₁ to x₂ about z₁ and `angle` gives φ, φ̇ and φ̈. Units: rad, rad/s, rad/s².
///
/// Holds where both z axes agree, as in a revolute or cylindrical joint.
pub fn angle<T: RealField + Copy>(
    first: &MarkerMotion<T>,
    second: &MarkerMotion<T>,
    angle: &[T; 3],
) -> Row<T> {
    let [value, rate, acceleration] = *angle;
    let [x, y, z] = axes(first);
    let [direction, ..] = axes(second);
    let (sine, cosine) = value.sin_cos();
    // the y axis of the first marker turned by φ; it turns with ω₁ + φ̇ z₁
    let turned = y * cosine - x * sine;
    let turning = first.angular_velocity + z * rate;
    let bias = z * acceleration + first.angular_velocity.cross(&z) * rate;
    let normal = turned.cross(&direction);
    driven(&turned, &turning, &bias, &direction, &second.angular_velocity, z.dot(&normal) * rate)
}
