//! The origins coincide and the z axes stay at right angles: two rotations are left.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, axes, coincident, perpendicular};

/// The origins coincide and the z axes stay at right angles: two rotations are left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Universal;

impl JointShape for Universal {
    const ROWS: &'static [&'static str] = &["translation x", "translation y", "translation z", "rotation"];
}

impl<T: RealField + Copy> Joint<T> for Universal {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        coincident(rows, first, second);
        let ([.., u], [.., w]) = (axes(first), axes(second));
        rows.push(perpendicular(first, second, &u, &w));
    }
}
