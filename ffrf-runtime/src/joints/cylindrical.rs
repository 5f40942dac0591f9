//! The z axes are one line: one rotation and the travel along it are left.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, in_line, parallel};

/// The z axes are one line: one rotation and the travel along it are left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cylindrical;

impl JointShape for Cylindrical {
    const ROWS: &'static [&'static str] = &["translation x", "translation y", "rotation x", "rotation y"];
}

impl<T: RealField + Copy> Joint<T> for Cylindrical {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        in_line(rows, first, second);
        parallel(rows, first, second);
    }
}
