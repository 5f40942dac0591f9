//! A force and a moment along the axis of a joint, as a controller wants them.

use nalgebra::{RealField, Vector3};

use super::ForceElement;
use crate::body::{MarkerMotion, Wrench};

/// A force along and a moment about the z axis of the first triad, on the second end; the first gets their reaction.
///
/// The inputs are those of a controller, set between steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Actuator<T = f64> {
    /// Force on the second end. Units: N.
    pub force: T,
    /// Moment on the second end. Units: N m.
    pub moment: T,
}

impl<T: RealField + Copy> Actuator<T> {
    /// An actuator that does nothing yet.
    pub fn idle() -> Self {
        Self { force: T::zero(), moment: T::zero() }
    }
}

impl<T: RealField + Copy> ForceElement<T> for Actuator<T> {
    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2] {
        let axis = first.orientation.transform_vector(&Vector3::z());
        let (force, moment) = (axis * self.force, axis * self.moment);
        // the reaction acts at the second end: force and moment are in balance
        let arm = second.position - first.position;
        [Wrench { force: -force, moment: -moment - arm.cross(&force) }, Wrench { force, moment }]
    }
}
