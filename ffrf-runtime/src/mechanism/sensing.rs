//! What can be measured in an evaluated mechanism.

use nalgebra::{RealField, Vector3};

use super::{Attachment, Plan, Ports, Storage};
use crate::body::Wrench;

/// The acceleration of an attachment. Shape: 3. Units: m/s². Frame: inertial.
pub fn acceleration<T: RealField + Copy>(at: &Attachment<T>, ports: &dyn Ports<T>) -> Vector3<T> {
    let twist = at.body.and_then(|body| ports.port(body)).map(|port| port.resulting_twist(at.marker)[0]);
    at.motion(ports).acceleration_bias + twist.unwrap_or_else(Vector3::zeros)
}

/// Force and moment of a joint on its second body, at the attachment there. Units: N, N m. Frame: inertial.
///
/// A joint and its drive are two: their reactions are to be added.
pub fn reaction<T: RealField + Copy>(plan: &Plan<'_>, storage: &Storage<'_, T>, joint: usize) -> Wrench<T> {
    let mut sum = Wrench::zero();
    let (Some(place), Some(Some(evaluated))) = (plan.joints.get(joint), storage.joints.get(joint)) else {
        return sum;
    };
    let multipliers = storage.solution.get(place.node).into_iter().flatten();
    for (row, negative) in evaluated.rows.iter().zip(multipliers) {
        let multiplier = -*negative;
        sum.force += row.second.force * multiplier;
        sum.moment += row.second.moment * multiplier;
    }
    sum
}
