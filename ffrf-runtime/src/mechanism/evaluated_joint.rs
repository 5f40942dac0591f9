//! A joint in one state: the motion of its ends and the rows that follow from it.

use nalgebra::{RealField, UnitQuaternion, Vector3};

use crate::body::MarkerMotion;
use crate::relations::{Row, Rows};

/// A joint, or the soft rows of a force element, in one state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EvaluatedJoint<T: RealField + Copy = f64> {
    /// Its rows.
    pub rows: Rows<T>,
    /// Motion of its first and second end.
    pub ends: [MarkerMotion<T>; 2],
}

impl<T: RealField + Copy> EvaluatedJoint<T> {
    /// A joint in this place, before its ends are moved and its rows are evaluated.
    #[inline]
    pub(super) fn put(place: &mut Option<Self>) -> &mut Self {
        // made where it stays
        let joint = place.get_or_insert_with(|| {
            let still = MarkerMotion::fixed(Vector3::zeros(), UnitQuaternion::identity());
            Self { rows: Rows::none(), ends: [still; 2] }
        });
        joint.rows.restart();
        joint
    }

    /// Residual and rate of each row.
    pub fn residuals(&self) -> impl Iterator<Item = [T; 2]> + '_ {
        let [first, second] = &self.ends;
        self.rows.iter().map(move |row: Row<T>| [row.residual, row.velocity(first, second)])
    }
}
