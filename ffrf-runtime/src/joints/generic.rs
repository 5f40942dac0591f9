//! Any choice of translations and rotations is held, along and about the axes of the first triad.

use nalgebra::RealField;

use super::Joint;
use crate::body::MarkerMotion;
use crate::relations::{Rows, aligned, axes, in_plane};

/// Any choice of translations and rotations is held, along and about the axes of the first triad.
///
/// A rotation that is held while another one is free keeps the component of the relative quaternion at zero: for one
/// free rotation this is a revolute joint, for two it is one sound choice of many while the free angles are small.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Generic {
    /// Whether the translation along x, y and z is held.
    pub translation: [bool; 3],
    /// Whether the rotation about x, y and z is held.
    pub rotation: [bool; 3],
}

impl<T: RealField + Copy> Joint<T> for Generic {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        for (axis, held) in axes(first).into_iter().zip(self.translation) {
            if held {
                rows.push(in_plane(first, second, &axis, &[T::zero(); 3]));
            }
        }
        aligned(rows, first, second, self.rotation);
    }
}
