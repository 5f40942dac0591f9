//! The origins keep a distance: a massless rod with a ball at each end.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, distance};

/// The origins keep a distance: a massless rod with a ball at each end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance<T = f64> {
    /// The length of the rod, positive. Units: m.
    pub length: T,
}

impl<T> JointShape for Distance<T> {
    const ROWS: &'static [&'static str] = &["distance"];
}

impl<T: RealField + Copy> Joint<T> for Distance<T> {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        rows.push(distance(first, second, self.length));
    }
}
