//! The second origin's coordinate along the z axis of the first triad follows a drive.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, axes, in_plane};

/// The second origin's coordinate along the z axis of the first triad follows a drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Travel;

impl JointShape for Travel {
    const ROWS: &'static [&'static str] = &["travel"];
}

impl<T: RealField + Copy> Joint<T> for Travel {
    fn push_rows(
        &self,
        rows: &mut Rows<T>,
        first: &MarkerMotion<T>,
        second: &MarkerMotion<T>,
        drive: &[T; 3],
    ) {
        let [.., normal] = axes(first);
        rows.push(in_plane(first, second, &normal, drive));
    }
}
