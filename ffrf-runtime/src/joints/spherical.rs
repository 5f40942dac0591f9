//! The origins coincide: three rotations are left.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, coincident};

/// The origins coincide: three rotations are left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Spherical;

impl JointShape for Spherical {
    const ROWS: &'static [&'static str] = &["translation x", "translation y", "translation z"];
}

impl<T: RealField + Copy> Joint<T> for Spherical {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        coincident(rows, first, second);
    }
}
