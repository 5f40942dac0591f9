//! What acts between two marker triads.

use nalgebra::RealField;

use crate::body::{MarkerMotion, MarkerStep, Wrench};

/// A force element: wrenches on two ends in their motion.
pub trait ForceElement<T: RealField + Copy> {
    /// Wrenches on the first and the second end. Frame: inertial.
    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2];

    /// Wrenches over a step of the energy-momentum method. Elements that store energy do exactly the work of its change
    /// there; others act as in the means.
    fn wrenches_over(&self, first: &MarkerStep<T>, second: &MarkerStep<T>) -> [Wrench<T>; 2] {
        self.wrenches(&first.mean, &second.mean)
    }

    /// Stored energy; zero for elements that store none. Units: J.
    fn energy(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let _ = (first, second);
        T::zero()
    }
}
