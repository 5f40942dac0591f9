//! The second origin stays in the xy plane of the first triad.

use nalgebra::RealField;

use super::{Joint, JointShape};
use crate::body::MarkerMotion;
use crate::relations::{Rows, axes, in_plane};

/// The second origin stays in the xy plane of the first triad.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct InPlane;

impl JointShape for InPlane {
    const ROWS: &'static [&'static str] = &["translation z"];
}

impl<T: RealField + Copy> Joint<T> for InPlane {
    fn push_rows(&self, rows: &mut Rows<T>, first: &MarkerMotion<T>, second: &MarkerMotion<T>, _: &[T; 3]) {
        let [.., normal] = axes(first);
        rows.push(in_plane(first, second, &normal, &[T::zero(); 3]));
    }
}
