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
    fn rows(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) -> Rows<T> {
        let mut rows = Rows::none();
        coincident(&mut rows, first, second);
        aligned(&mut rows, first, second, [true; 3]);
        rows
    }
}
