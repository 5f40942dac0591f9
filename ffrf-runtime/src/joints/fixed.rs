//! Both triads coincide: no motion is left.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, aligned, coincident};

/// Both triads coincide: no motion is left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Fixed;

impl JointShape for Fixed {
    const ROWS: &'static [&'static str] =
        &["translation x", "translation y", "translation z", "rotation x", "rotation y", "rotation z"];
}

impl<T: RealField + Copy> Joint<T> for Fixed {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        coincident(rows, first, second);
        aligned(rows, first, second, [true; 3]);
    }
}
