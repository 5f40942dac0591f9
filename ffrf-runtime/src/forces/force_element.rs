//! What acts between two marker triads.

use nalgebra::RealField;

use super::SoftRow;
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

    /// Pushes the directions in which it resists like a spring and a damper, which implicit steps take into their matrix:
    /// always as many, of those that change nothing too. None by default.
    ///
    /// They need not be the exact derivatives of the wrenches: the order of steps does not depend on them, how large a step may
    /// be does. Where the exact ones push apart they are left out.
    fn soften(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>, push: &mut dyn FnMut(SoftRow<T>)) {
        let _ = (first, second, push);
    }

    /// Stored energy; zero for elements that store none. Units: J.
    fn energy(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let _ = (first, second);
        T::zero()
    }
}
