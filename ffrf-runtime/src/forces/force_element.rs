//! What acts between two marker triads.

use nalgebra::RealField;

use crate::body::{MarkerMotion, Wrench};

/// A force element: wrenches on two ends in their motion.
pub trait ForceElement<T: RealField + Copy> {
    /// Wrenches on the first and the second end. Frame: inertial.
    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2];

    /// Stored energy; zero for elements that store none. Units: J.
    fn energy(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let _ = (first, second);
        T::zero()
    }
}
