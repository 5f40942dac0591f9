//! A bushing: springs and dampers along and about the axes of a triad.

use nalgebra::{RealField, Vector3};

use super::ForceElement;
use crate::body::{MarkerMotion, Wrench};

/// A bushing, linear in displacement and rotation vector of the second triad in the first.
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
        let turn = rotation_vector(first, second);
        let spin = to_first(&(second.angular_velocity - first.angular_velocity));
        let [k_x, k_y, k_z, c_x, c_y, c_z] = self.stiffness;
        let [d_x, d_y, d_z, e_x, e_y, e_z] = self.damping;
        let force = displacement.component_mul(&Vector3::new(k_x, k_y, k_z))
            + velocity.component_mul(&Vector3::new(d_x, d_y, d_z));
        let moment = turn.component_mul(&Vector3::new(c_x, c_y, c_z))
            + spin.component_mul(&Vector3::new(e_x, e_y, e_z));
        let (force, moment) =
            (first.orientation.transform_vector(&force), first.orientation.transform_vector(&moment));
        [Wrench { force, moment: moment + between.cross(&force) }, Wrench { force: -force, moment: -moment }]
    }

    /// Stored energy. Units: J.
    fn energy(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let displacement = first.orientation.inverse_transform_vector(&(second.position - first.position));
        let turn = rotation_vector(first, second);
        let squares = displacement.iter().chain(turn.iter()).zip(self.stiffness);
        let sum = squares.fold(T::zero(), |sum, (value, stiffness)| sum + *value * *value * stiffness);
        sum * nalgebra::convert(0.5)
    }
}

/// Twice the vector part of the relative quaternion: the rotation vector to second order. Frame: the first triad.
fn rotation_vector<T: RealField + Copy>(first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> Vector3<T> {
    let relative = first.orientation.inverse() * second.orientation;
    let two: T = nalgebra::convert(2.0);
    let sign = if relative.w < T::zero() { -two } else { two };
    relative.imag() * sign
}
