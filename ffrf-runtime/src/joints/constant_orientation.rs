//! Both triads keep the same orientation: three translations are left.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, aligned};

/// Both triads keep the same orientation: three translations are left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ConstantOrientation;

impl JointShape for ConstantOrientation {
    const ROWS: &'static [&'static str] = &["rotation x", "rotation y", "rotation z"];
}

impl<T: RealField + Copy> Joint<T> for ConstantOrientation {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        aligned(rows, first, second, [true; 3]);
    }
}
