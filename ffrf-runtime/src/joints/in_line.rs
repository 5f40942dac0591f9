//! The second origin stays on the z axis of the first triad.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, in_line};

/// The second origin stays on the z axis of the first triad.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct InLine;

impl JointShape for InLine {
    const ROWS: &'static [&'static str] = &["translation x", "translation y"];
}

impl<T: RealField + Copy> Joint<T> for InLine {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        in_line(rows, first, second);
    }
}
