//! Where the rows of a joint act.

use nalgebra::{RealField, Vector3};

use super::{Connection, EvaluatedJoint};

/// How far the rows of a joint act beyond one of its ends.
///
/// Both ends are seen where the second one is: rows that hold a point or a distance do not ask where, and the others have the
/// moment of that distance at their first end.
#[inline(always)]
pub(super) fn beyond<T: RealField + Copy>(
    connection: &Connection<T>,
    joint: &EvaluatedJoint<T>,
    second: bool,
) -> Vector3<T> {
    if second || connection.kind.holds_point() {
        Vector3::zeros()
    } else {
        joint.ends[1].position - joint.ends[0].position
    }
}
