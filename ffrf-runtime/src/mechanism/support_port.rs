//! A body in a mechanism as the joint with the ground sees it that it stands on.

use nalgebra::{RealField, Vector3};

use super::Support;

/// One body that may stand on a support. An object, as [`Port`](super::Port) is.
pub trait SupportPort<T: RealField + Copy> {
    /// Lets a rigid body that has its factors move as a support leaves it: from then on its unknowns are these motions. Whether it can.
    fn stand_on(&mut self, support: &Support<'_, T>) -> bool;
    /// Which of the ends of joints on the body is the support that it stands on.
    fn support(&self) -> Option<usize>;
    /// Takes what the rows of the support that it stands on are to do. Shape: rows.
    fn ask_of_support(&mut self, wanted: &[T; 6]);
    /// What a marker does if the body moves only as its support asks: [linear, angular] (inertial). `None` without a support.
    fn supported_twist(&self, marker: usize) -> Option<[Vector3<T>; 2]>;
    /// The right-hand side where no forces act: what its support asks for. Shape: 6.
    fn unforced(&self) -> [T; 6];
}
