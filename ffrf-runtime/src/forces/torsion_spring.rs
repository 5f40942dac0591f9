//! A linear spring and damper about the axis of a joint.

use nalgebra::{RealField, Vector3};

use super::ForceElement;
use crate::body::{MarkerMotion, Wrench};

/// A spring with a damper about the z axis of the first triad, for joints that keep both z axes together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionSpring<T = f64> {
    /// Units: N m/rad.
    pub stiffness: T,
    /// Units: N m s/rad.
    pub damping: T,
    /// Angle without moment, within half a turn. Units: rad.
    pub rest_angle: T,
}

impl<T: RealField + Copy> ForceElement<T> for TorsionSpring<T> {
    /// Wrenches on both ends (inertial).
    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2] {
        let axis = first.orientation.transform_vector(&Vector3::z());
        let rate = axis.dot(&(second.angular_velocity - first.angular_velocity));
        let angle = self.turn(first, second);
        let moment = axis * (self.stiffness * angle + self.damping * rate);
        let force = Vector3::zeros();
        [Wrench { force, moment }, Wrench { force, moment: -moment }]
    }

    /// Stored energy. Units: J.
    fn energy(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let angle = self.turn(first, second);
        self.stiffness * angle * angle * nalgebra::convert(0.5)
    }
}

impl<T: RealField + Copy> TorsionSpring<T> {
    /// The angle from rest, within half a turn.
    fn turn(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let angle = relative_angle(first, second) - self.rest_angle;
        let (turn, half) = (T::two_pi(), T::pi());
        if angle > half {
            angle - turn
        } else if angle < -half {
            angle + turn
        } else {
            angle
        }
    }
}

/// The angle from x₁ to x₂ about z₁, within half a turn. Units: rad.
pub fn relative_angle<T: RealField + Copy>(first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
    let direction = second.orientation.transform_vector(&Vector3::x());
    let x = first.orientation.transform_vector(&Vector3::x());
    let y = first.orientation.transform_vector(&Vector3::y());
    y.dot(&direction).atan2(x.dot(&direction))
}
