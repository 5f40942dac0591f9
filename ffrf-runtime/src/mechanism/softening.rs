//! Evaluation of the soft rows of a mechanism.

use nalgebra::RealField;

use super::{Assembly, Constraints, EvaluatedJoint, SoftLink, Storage};
use crate::relations::Row;

impl<T: RealField + Copy> Constraints<'_, '_, T> {
    /// The soft rows in this state, behind those of the joints.
    pub(super) fn soften<A: Assembly<T>>(&mut self, assembly: &A, gamma_h: T) {
        let hard = self.connections.len();
        let Storage { joints, soft_markers, .. } = &mut *self.storage;
        let storage = joints.iter_mut().skip(hard).zip(soft_markers.iter_mut());
        let places = self.plan.joints.iter().skip(hard);
        for (index, (place, (link, markers))) in places.zip(storage).enumerate() {
            let Some(SoftLink { element, ends: [first, second] }) = assembly.soft(index) else { continue };
            let joint = EvaluatedJoint::put(link);
            first.put_motion(self.ports, &mut joint.ends[0]);
            second.put_motion(self.ports, &mut joint.ends[1]);
            let EvaluatedJoint { rows, ends } = joint;
            *markers = [first.marker, second.marker];
            element.soften(&ends[0], &ends[1], &mut |row| rows.push(row.in_stage(gamma_h)));
            while rows.len() < place.rows {
                rows.push(Row::zero());
            }
        }
    }
}
