//! What a scene measures.

use ffrf_runtime::mechanism::Attachment;
use ffrf_runtime::{SectionMarker, StressMarker};

use super::SceneError;
use super::file::SensorTable;
use super::names::{NamedBody, attachment, named_in_a_body};
use crate::HostModal;

/// A sensor of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensor {
    /// Its name, the head of its columns.
    pub name: String,
    /// What it measures.
    pub kind: SensorKind,
}

/// What a sensor measures.
#[derive(Debug, Clone, PartialEq)]
pub enum SensorKind {
    /// Position. Units: m. Frame: inertial.
    Position(Attachment<f64>),
    /// Velocity. Units: m/s. Frame: inertial.
    Velocity(Attachment<f64>),
    /// Acceleration. Units: m/s². Frame: inertial.
    Acceleration(Attachment<f64>),
    /// Euler parameters, scalar first.
    Orientation(Attachment<f64>),
    /// Angle of a joint about its axis, from the first to the second frame, counted over turns. Units: rad.
    Angle(usize),
    /// Force of a joint on its second body. Units: N. Frame: inertial.
    ReactionForce(Vec<usize>),
    /// Moment of a joint on its second body about the attachment there. Units: N m. Frame: inertial.
    ReactionMoment(Vec<usize>),
    /// Stress of a body at a stress marker, and von Mises' equivalent. Units: N/m². Frame: body.
    Stress {
        /// Number of the body.
        body: usize,
        /// The marker.
        marker: Box<StressMarker<HostModal, f64>>,
    },
    /// Force and moment through a cut of a body. Units: N, N m. Frame: body.
    SectionForce {
        /// Number of the body.
        body: usize,
        /// The marker.
        marker: Box<SectionMarker<HostModal, f64>>,
    },
}

impl SensorKind {
    /// The endings of its columns.
    pub fn columns(&self) -> &'static [&'static str] {
        match self {
            Self::Angle(_) => &[""],
            Self::Orientation(_) => &[".w", ".x", ".y", ".z"],
            Self::SectionForce { .. } => &[".fx", ".fy", ".fz", ".mx", ".my", ".mz"],
            Self::Stress { .. } => &[".xx", ".yy", ".zz", ".xy", ".xz", ".yz", ".von_mises"],
            _ => &[".x", ".y", ".z"],
        }
    }
}

const KINDS: &str = "position, velocity, acceleration, orientation, angle, reaction_force, reaction_moment, stress, section_force";

/// The sensor of a table. `joints`: names and connections of each joint, its drive included.
pub(super) fn sensor(
    name: &str,
    table: &SensorTable,
    bodies: &mut [NamedBody],
    joints: &[(String, Vec<usize>)],
) -> Result<Sensor, SceneError> {
    let key = format!("sensors.{name}");
    let of = format!("{key}.of");
    if table.kind == "stress" {
        let (body, marker) =
            named_in_a_body(bodies, &of, "stress marker", &table.of, |it| &it.stress_markers)?;
        let kind = SensorKind::Stress { body, marker: Box::new(marker) };
        return Ok(Sensor { name: name.to_owned(), kind });
    }
    if table.kind == "section_force" {
        let (body, marker) = named_in_a_body(bodies, &of, "section", &table.of, |it| &it.section_markers)?;
        let kind = SensorKind::SectionForce { body, marker: Box::new(marker) };
        return Ok(Sensor { name: name.to_owned(), kind });
    }
    let mut at = || attachment(bodies, &of, &table.of, None);
    let joint = || {
        let found =
            joints.iter().find(|(name, _)| *name == table.of).map(|(_, connections)| connections.clone());
        found.ok_or_else(|| SceneError::Unknown {
            key: of.clone(),
            kind: "joint",
            found: table.of.escape_debug().to_string(),
            known: joints.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(", "),
        })
    };
    let kind = match table.kind.as_str() {
        "position" => SensorKind::Position(at()?),
        "velocity" => SensorKind::Velocity(at()?),
        "acceleration" => SensorKind::Acceleration(at()?),
        "orientation" => SensorKind::Orientation(at()?),
        "angle" => SensorKind::Angle(joint()?[0]),
        "reaction_force" => SensorKind::ReactionForce(joint()?),
        "reaction_moment" => SensorKind::ReactionMoment(joint()?),
        other => {
            return Err(SceneError::Unknown {
                key: format!("{key}.kind"),
                kind: "kind of sensor",
                found: other.escape_debug().to_string(),
                known: KINDS.to_owned(),
            });
        }
    };
    Ok(Sensor { name: name.to_owned(), kind })
}
