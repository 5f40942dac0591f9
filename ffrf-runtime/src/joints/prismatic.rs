//! The z axes are one line and nothing turns: the travel along it is left.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, aligned, in_line};

/// The z axes are one line and nothing turns: the travel along it is left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Prismatic;

impl JointShape for Prismatic {
    const ROWS: &'static [&'static str] =
        &["translation x", "translation y", "rotation x", "rotation y", "rotation z"];
}

impl<T: RealField + Copy> Joint<T> for Prismatic {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        in_line(rows, first, second);
        aligned(rows, first, second, [true; 3]);
    }
}
