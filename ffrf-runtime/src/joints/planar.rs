//! The xy planes are one: two translations and the rotation about z are left.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, axes, in_plane, parallel};

/// The xy planes are one: two translations and the rotation about z are left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Planar;

impl JointShape for Planar {
    const ROWS: &'static [&'static str] = &["translation z", "rotation x", "rotation y"];
}

impl<T: RealField + Copy> Joint<T> for Planar {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        let [.., normal] = axes(first);
        rows.push(in_plane(first, second, &normal, &[T::zero(); 3]));
        parallel(rows, first, second);
    }
}
