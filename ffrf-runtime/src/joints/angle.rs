//! The angle about the z axis of the first triad follows a drive; goes with a joint that keeps the z axes together.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, angle};

/// The angle about the z axis of the first triad follows a drive; goes with a joint that keeps the z axes together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Angle;

impl JointShape for Angle {
    const ROWS: &'static [&'static str] = &["angle"];
}

impl<T: RealField + Copy> Joint<T> for Angle {
    fn push_rows(
        &self,
        rows: &mut Rows<T>,
        first: &MarkerMotion<T>,
        second: &MarkerMotion<T>,
        drive: &[T; 3],
    ) {
        rows.push(angle(first, second, drive));
    }
}
