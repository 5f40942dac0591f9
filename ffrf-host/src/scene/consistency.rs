//! Whether positions, velocities and accelerations of a state can all meet the joints.

use ffrf_runtime::mechanism::{Assembly, Constrained, EvaluatedJoint, Ports};
use ffrf_runtime::{State, StepError};
use nalgebra::Vector3;

use crate::{HostMechanism, HostModal};

/// What is left of one joint's rows (m or rad, and per second, and per second squared).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residuals {
    /// Largest residuals of positions, velocities and accelerations.
    pub left: [f64; 3],
    /// The largest of the terms that these are the sums of: one for positions, velocities and accelerations of both ends.
    pub scale: [f64; 3],
}

/// The residuals of each joint in a state, with the accelerations that the mechanism has there.
///
/// Errors: there are no accelerations.
pub fn residuals(
    mechanism: &HostMechanism,
    time: f64,
    state: &[State<HostModal>],
) -> Result<Vec<Residuals>, StepError> {
    Constrained(mechanism).evaluate(time, state.to_vec(), None, |ports, storage| {
        let joints = mechanism.connections().iter().zip(storage.evaluated());
        joints
            .map(|(connection, EvaluatedJoint { rows, ends: [first, second] })| {
                let accelerations = [&connection.first, &connection.second].map(|end| {
                    let port = end.body.and_then(|body| ports.port(body));
                    port.map_or([Vector3::zeros(); 2], |port| port.resulting_twist(end.marker))
                });
                let mut found = Residuals { left: [0.0; 3], scale: [1.0; 3] };
                for row in rows.iter() {
                    let parts = [
                        row.first.power(&accelerations[0][0], &accelerations[0][1]),
                        row.second.power(&accelerations[1][0], &accelerations[1][1]),
                        row.whole_bias(first, second),
                    ];
                    let rates = [
                        row.first.power(&first.velocity, &first.angular_velocity),
                        row.second.power(&second.velocity, &second.angular_velocity),
                        row.rate,
                    ];
                    let left = [row.residual, rates.iter().sum(), parts.iter().sum()];
                    for (largest, one) in found.left.iter_mut().zip(left) {
                        // what is not a number stays
                        if !one.is_finite() || one.abs() > *largest {
                            *largest = one.abs();
                        }
                    }
                    for (scale, terms) in found.scale[1..].iter_mut().zip([rates, parts]) {
                        *scale = terms.iter().fold(*scale, |scale, term| scale.max(term.abs()));
                    }
                }
                found
            })
            .collect()
    })
}
