//! A constant force and a constant moment at the second end.

use nalgebra::{RealField, Vector3};

use super::{ForceElement, Frame};
use crate::body::{MarkerMotion, Wrench};

/// A constant force and a constant moment at the second end, fixed in space or turning with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConstantWrench<T = f64> {
    /// Force. Shape: 3. Units: N. Frame: `frame`.
    pub force: Vector3<T>,
    /// Moment. Shape: 3. Units: N m. Frame: `frame`.
    pub moment: Vector3<T>,
    /// The frame of both; that of the body is the second end's triad.
    pub frame: Frame,
}

impl<T: RealField + Copy> ForceElement<T> for ConstantWrench<T> {
    fn wrenches(&self, _: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2] {
        let turned = |vector: &Vector3<T>| match self.frame {
            Frame::Inertial => *vector,
            Frame::Body => second.orientation.transform_vector(vector),
        };
        [Wrench::zero(), Wrench { force: turned(&self.force), moment: turned(&self.moment) }]
    }
}
