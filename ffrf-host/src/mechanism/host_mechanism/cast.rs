//! The same mechanism in another number type, or with its drives held.

use ffrf_runtime::mechanism::{Connection, JointFriction, Regularisation, Treatment};
use nalgebra::{RealField, convert};

use super::HostMechanism;
use crate::mechanism::{Drive, Element, ScheduledActuator};
use crate::{HostBody, HostModal};

/// A tolerance that the number type can meet: what holds in double precision cannot be met in single.
fn as_exact_as<T: RealField + Copy>(tolerance: T) -> T {
    match Treatment::<T>::projection() {
        Treatment::Projection { tolerance: own, .. } if T::default_epsilon() > convert(1e-10) => {
            own.max(tolerance)
        }
        _ => tolerance,
    }
}

impl HostMechanism {
    /// The same mechanism with every drive held at its value at `time` (s); forces of users' own stay behind.
    pub fn with_drives_held(&self, time: f64) -> Self {
        let mut held = self.cast();
        for drive in held.drives.iter_mut().flatten() {
            *drive = Drive::Polynomial(vec![drive.at(time)[0]]);
        }
        held
    }

    /// The same mechanism in another number type; forces of users' own stay behind.
    pub fn cast<T: RealField + Copy>(&self) -> HostMechanism<T> {
        HostMechanism {
            bodies: self.bodies.iter().map(HostBody::cast).collect(),
            markers: self
                .markers
                .iter()
                .map(|list| list.iter().map(HostModal::cast_marker).collect())
                .collect(),
            connections: self.connections.iter().map(Connection::cast).collect(),
            drives: self.drives.clone(),
            drive_values: None,
            gravity: self.gravity.map(convert),
            elements: self
                .elements
                .iter()
                .map(|element| Element {
                    kind: element.kind.cast(),
                    first: element.first.cast(),
                    second: element.second.cast(),
                })
                .collect(),
            actuators: self.actuators.iter().map(ScheduledActuator::cast).collect(),
            frictions: self.frictions.iter().map(JointFriction::cast).collect(),
            forces: None,
            topology: self.topology.clone(),
            keeping: self.keeping.clone(),
            plan: self.plan.clone(),
            soft: self.soft.clone(),
            treatment: match self.treatment {
                Treatment::Projection { iterations, tolerance } => {
                    Treatment::Projection { iterations, tolerance: as_exact_as::<T>(convert(tolerance)) }
                }
                Treatment::Baumgarte { alpha, beta } => {
                    Treatment::Baumgarte { alpha: convert(alpha), beta: convert(beta) }
                }
                Treatment::Index3 => Treatment::Index3,
                Treatment::StabilisedIndex2 => Treatment::StabilisedIndex2,
            },
            regularisation: if self.regularisation.share > 0.0 {
                Regularisation::of_loops()
            } else {
                Regularisation::of_trees()
            },
        }
    }
}
