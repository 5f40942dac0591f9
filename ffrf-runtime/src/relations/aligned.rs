//! Both triads keep the same orientation, about chosen axes of the first.

use nalgebra::RealField;

use super::{Row, Rows};
use crate::body::{MarkerMotion, Wrench};

/// 2 u = 0, where (s, u) is the quaternion from the first to the second triad: about the chosen axes of the first.
///
/// Rational in the orientations; the rotation vector to second order; unique up to relative turns of 180 degrees.
pub fn aligned<T: RealField + Copy>(
    rows: &mut Rows<T>,
    first: &MarkerMotion<T>,
    second: &MarkerMotion<T>,
    about: [bool; 3],
) {
    let (half, two): (T, T) = (nalgebra::convert(0.5), nalgebra::convert(2.0));
    let to_first = first.orientation.inverse();
    let relative = to_first * second.orientation;
    // both signs are the same orientation: the one near the identity
    let sign = if relative.w < T::zero() { -T::one() } else { T::one() };
    let (s, u) = (relative.w * sign, relative.imag() * sign);
    let frame = to_first.transform_vector(&first.angular_velocity);
    let omega = to_first.transform_vector(&(second.angular_velocity - first.angular_velocity));
    // u̇ = ½ (s ω + ω × u), so ġ = s ω + ω × u
    let s_rate = -omega.dot(&u) * half;
    let u_rate = (omega * s + omega.cross(&u)) * half;
    // ω̇ in the first frame is that of the bodies less ω₁ × ω
    let carried = -frame.cross(&omega);
    let bias = carried * s + carried.cross(&u) + omega * s_rate + omega.cross(&u_rate);
    for axis in 0..3 {
        if !about.get(axis).copied().unwrap_or(false) {
            continue;
        }
        let mut unit = nalgebra::Vector3::zeros();
        unit[axis] = T::one();
        // e · (s ω + ω × u) = ω · (s e + u × e)
        let gradient = first.orientation.transform_vector(&(unit * s + u.cross(&unit)));
        rows.push(Row {
            residual: u[axis] * two,
            first: Wrench { force: nalgebra::Vector3::zeros(), moment: -gradient },
            second: Wrench { force: nalgebra::Vector3::zeros(), moment: gradient },
            rate: T::zero(),
            bias: bias[axis],
        });
    }
}
