//! A bushing: springs and dampers along and about the axes of a triad.

use nalgebra::{RealField, Vector3};

use super::ForceElement;
use crate::body::{MarkerMotion, Wrench};

/// A bushing: displacement of the second triad in the first, and twice the vector part u of the quaternion between both, which
/// is the rotation vector to second order. Forces are the exact gradient of the energy ½ Σ k d² + ½ Σ c (2 u)².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bushing<T = f64> {
    /// Stiffness along x, y, z, then about them. Units: N/m and N m/rad.
    pub stiffness: [T; 6],
    /// Damping along x, y, z, then about them. Units: N s/m and N m s/rad.
    pub damping: [T; 6],
}

impl<T: RealField + Copy> ForceElement<T> for Bushing<T> {
    /// Wrenches on both ends (inertial). Force and moment act at the second end; the first gets their reaction there.
    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2] {
        let between = second.position - first.position;
        let to_first = |vector: &Vector3<T>| first.orientation.inverse_transform_vector(vector);
        let displacement = to_first(&between);
        // seen from the first triad, which turns
        let velocity = to_first(&(second.velocity - first.velocity - first.angular_velocity.cross(&between)));
        let relative = relative_rotation(first, second);
        let spin = to_first(&(second.angular_velocity - first.angular_velocity));
        let [k_x, k_y, k_z, c_x, c_y, c_z] = self.stiffness;
        let [d_x, d_y, d_z, e_x, e_y, e_z] = self.damping;
        let force = displacement.component_mul(&Vector3::new(k_x, k_y, k_z))
            + velocity.component_mul(&Vector3::new(d_x, d_y, d_z));
        // the gradient of the stored energy, exact for every turn: u̇ = ½ (s ω + ω × u)
        let (s, u) = (relative.w, relative.imag());
        let two: T = nalgebra::convert(2.0);
        let restoring = u.component_mul(&Vector3::new(c_x, c_y, c_z)) * two;
        let moment = restoring * s + u.cross(&restoring) + spin.component_mul(&Vector3::new(e_x, e_y, e_z));
        let (force, moment) =
            (first.orientation.transform_vector(&force), first.orientation.transform_vector(&moment));
        [Wrench { force, moment: moment + between.cross(&force) }, Wrench { force: -force, moment: -moment }]
    }

    /// Stored energy. Units: J.
    fn energy(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let displacement = first.orientation.inverse_transform_vector(&(second.position - first.position));
        let two: T = nalgebra::convert(2.0);
        let turn = relative_rotation(first, second).imag() * two;
        let squares = displacement.iter().chain(turn.iter()).zip(self.stiffness);
        let sum = squares.fold(T::zero(), |sum, (value, stiffness)| sum + *value * *value * stiffness);
        sum * nalgebra::convert(0.5)
    }
}

/// The quaternion (s, u) from the first to the second triad with s >= 0. Frame: the first triad.
fn relative_rotation<T: RealField + Copy>(
    first: &MarkerMotion<T>,
    second: &MarkerMotion<T>,
) -> nalgebra::Quaternion<T> {
    let relative = (first.orientation.inverse() * second.orientation).into_inner();
    if relative.w < T::zero() { -relative } else { relative }
}
