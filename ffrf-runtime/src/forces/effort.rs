//! Forces and moments of one number between two triads: what actuators and friction in joints exert.

use nalgebra::{RealField, Vector3};

use crate::body::{MarkerMotion, Wrench};

/// Where a single force or moment acts between two triads, and which rate it has power on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// A moment about the z axis of the first triad; its rate is that of the second triad about it.
    About,
    /// A force along the z axis of the first triad at the second origin; its rate is that of the travel along it.
    Along,
    /// A force on the line through both origins, positive apart; its rate is that of their distance.
    Line,
}

impl Effort {
    /// Wrenches on both ends (inertial): `effort` on the second end, its reaction on the first. Units: N or N m.
    ///
    /// Where the ends of a line meet, it has no direction and there is no force.
    pub fn wrenches<T: RealField + Copy>(
        self,
        first: &MarkerMotion<T>,
        second: &MarkerMotion<T>,
        effort: T,
    ) -> [Wrench<T>; 2] {
        let direction = self.direction(first, second) * effort;
        let zero = Vector3::zeros();
        let [on_first, on_second] = match self {
            Self::About => [(zero, -direction), (zero, direction)],
            // the reaction acts on the first body at the second origin
            Self::Along => {
                let between = second.position - first.position;
                [(-direction, -between.cross(&direction)), (direction, zero)]
            }
            Self::Line => [(-direction, zero), (direction, zero)],
        };
        [on_first, on_second].map(|(force, moment)| Wrench { force, moment })
    }

    /// The rate that the effort has power on. Units: rad/s or m/s.
    pub fn rate<T: RealField + Copy>(self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let direction = self.direction(first, second);
        let velocity = second.velocity - first.velocity;
        match self {
            Self::About => direction.dot(&(second.angular_velocity - first.angular_velocity)),
            Self::Along => {
                let between = second.position - first.position;
                direction.dot(&(velocity - first.angular_velocity.cross(&between)))
            }
            Self::Line => direction.dot(&velocity),
        }
    }

    fn direction<T: RealField + Copy>(self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> Vector3<T> {
        match self {
            Self::About | Self::Along => first.orientation.transform_vector(&Vector3::z()),
            Self::Line => {
                let between = second.position - first.position;
                let length = between.norm();
                if length <= T::default_epsilon() { Vector3::zeros() } else { between / length }
            }
        }
    }
}
