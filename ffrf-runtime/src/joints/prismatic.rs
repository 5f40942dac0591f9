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
    fn rows(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) -> Rows<T> {
        let mut rows = Rows::none();
        in_line(&mut rows, first, second);
        aligned(&mut rows, first, second, [true; 3]);
        rows
    }
}
