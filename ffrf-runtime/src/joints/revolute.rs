//! The origins coincide and the z axes agree: one rotation is left.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, coincident, parallel};

/// The origins coincide and the z axes agree: one rotation is left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Revolute;

impl JointShape for Revolute {
    const ROWS: &'static [&'static str] =
        &["translation x", "translation y", "translation z", "rotation x", "rotation y"];
}

impl<T: RealField + Copy> Joint<T> for Revolute {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        coincident(rows, first, second);
        parallel(rows, first, second);
    }
}
