//! Force elements of a scene.

use std::path::Path;

use ffrf_runtime::State;
use ffrf_runtime::forces::{Actuator, Bushing, Effort, Friction, Spring, TorsionSpring, relative_angle};
use ffrf_runtime::joints::JointKind;
use ffrf_runtime::mechanism::{Attachment, Connection};
use nalgebra::Vector3;

use super::SceneError;
use super::file::{ForceTable, Vector};
use super::joints::{direction, function_of_time, triad};
use super::names::{NamedBody, attachment};
use crate::HostModal;
use crate::mechanism::{Drive, Element, ElementKind};

/// Every kind of force element by its name in scene files.
const KINDS: [&str; 7] = ["spring", "torsion_spring", "bushing", "friction", "actuator", "force", "moment"];

/// The joints of a scene, in which friction and actuators act.
pub(super) struct Joints<'a> {
    /// Names, and the connections of each.
    pub(super) names: &'a [(String, Vec<usize>)],
    pub(super) connections: &'a [(Connection<f64>, Option<Drive>)],
}

/// The force element of a table between bodies in their initial states.
pub(super) fn element(
    name: &str,
    table: &ForceTable,
    bodies: &mut [NamedBody],
    states: &[State<HostModal>],
    joints: &Joints<'_>,
    folder: &Path,
) -> Result<Element, SceneError> {
    let key = format!("forces.{name}");
    used(&key, table)?;
    if matches!(table.kind.as_str(), "friction" | "actuator") {
        return effort_element(&key, table, bodies, joints, folder);
    }
    let Some(second) = &table.second else {
        return Err(SceneError::value(format!("{key}.second"), "BODY or BODY.MARKER", "nothing"));
    };
    let first = table.first.as_deref().unwrap_or("ground");
    let mut first = attachment(bodies, &format!("{key}.first"), first, table.first_position)?;
    let mut second = attachment(bodies, &format!("{key}.second"), second, table.second_position)?;
    let number = |value, what, otherwise| number(&key, value, what, otherwise);
    let kind = match table.kind.as_str() {
        "spring" => {
            let ends = [triad(bodies, states, &first), triad(bodies, states, &second)];
            let initial = (ends[1].position - ends[0].position).norm();
            ElementKind::Spring(Spring {
                stiffness: number(table.stiffness, "stiffness", None)?,
                damping: number(table.damping, "damping", Some(0.0))?,
                rest_length: number(table.rest, "rest", Some(initial))?,
            })
        }
        "torsion_spring" => {
            let along_axis = direction(&format!("{key}.axis"), table.axis)?;
            let relative = triad(bodies, states, &first).orientation.inverse()
                * triad(bodies, states, &second).orientation;
            let seen = along_axis.inverse() * relative * along_axis;
            let turn = 2.0 * seen.k.atan2(seen.w);
            first.orientation *= along_axis;
            second.orientation *= relative.inverse()
                * along_axis
                * nalgebra::UnitQuaternion::from_axis_angle(&Vector3::z_axis(), turn);
            let initial = relative_angle(&triad(bodies, states, &first), &triad(bodies, states, &second));
            ElementKind::TorsionSpring(TorsionSpring {
                stiffness: number(table.stiffness, "stiffness", None)?,
                damping: number(table.damping, "damping", Some(0.0))?,
                rest_angle: table.rest.unwrap_or(initial),
            })
        }
        "bushing" => ElementKind::Bushing(Bushing {
            stiffness: six(&key, "stiffness_matrix", table.stiffness_matrix, None)?,
            damping: six(&key, "damping_matrix", table.damping_matrix, Some([0.0; 6]))?,
        }),
        "force" => ElementKind::Force { value: vector(&key, table.value)?, follows: follows(&key, table)? },
        "moment" => ElementKind::Moment { value: vector(&key, table.value)?, follows: follows(&key, table)? },
        _ => return Err(unknown_kind(&key, table)),
    };
    Ok(Element { kind, first, second })
}

fn unknown_kind(key: &str, table: &ForceTable) -> SceneError {
    SceneError::Unknown {
        key: format!("{key}.kind"),
        kind: "kind of force",
        found: table.kind.escape_debug().to_string(),
        known: KINDS.join(", "),
    }
}

/// Refuses kinds that do not exist and keys that this kind of force does not read.
fn used(key: &str, table: &ForceTable) -> Result<(), SceneError> {
    let kind = table.kind.as_str();
    if !KINDS.contains(&kind) {
        return Err(unknown_kind(key, table));
    }
    let only = [
        (table.joint.is_some(), "joint", &["friction", "actuator"][..]),
        (table.acts.is_some(), "acts", &["friction", "actuator"]),
        (table.limit.is_some(), "limit", &["friction", "actuator"]),
        (table.speed.is_some(), "speed", &["friction"]),
        (table.input.is_some(), "input", &["actuator"]),
        (table.gain.is_some(), "gain", &["actuator"]),
        (table.axis.is_some(), "axis", &["torsion_spring", "friction", "actuator"]),
        (table.stiffness.is_some(), "stiffness", &["spring", "torsion_spring"]),
        (table.damping.is_some(), "damping", &["spring", "torsion_spring", "friction"]),
        (table.rest.is_some(), "rest", &["spring", "torsion_spring"]),
        (table.stiffness_matrix.is_some(), "stiffness_matrix", &["bushing"]),
        (table.damping_matrix.is_some(), "damping_matrix", &["bushing"]),
        (table.value.is_some(), "value", &["force", "moment"]),
        (table.frame.is_some(), "frame", &["force", "moment"]),
    ];
    for (given, what, kinds) in only {
        if given && !kinds.contains(&kind) {
            let expected = format!("nothing: {what} is for {} only", kinds.join(", "));
            return Err(SceneError::value(format!("{key}.{what}"), expected, "a value"));
        }
    }
    Ok(())
}

/// Friction or an actuator, in a joint or between two attachments of its own.
fn effort_element(
    key: &str,
    table: &ForceTable,
    bodies: &mut [NamedBody],
    joints: &Joints<'_>,
    folder: &Path,
) -> Result<Element, SceneError> {
    let (first, second, usual) = match &table.joint {
        Some(joint) => in_joint(key, table, joint, joints)?,
        None => {
            let Some(second) = &table.second else {
                let expected = "BODY or BODY.MARKER, or a joint in `joint`";
                return Err(SceneError::value(format!("{key}.second"), expected, "nothing"));
            };
            let first = table.first.as_deref().unwrap_or("ground");
            let mut first = attachment(bodies, &format!("{key}.first"), first, table.first_position)?;
            first.orientation *= direction(&format!("{key}.axis"), table.axis)?;
            let second = attachment(bodies, &format!("{key}.second"), second, table.second_position)?;
            (first, second, None)
        }
    };
    let effort = match (table.acts.as_deref(), usual) {
        (Some("about"), _) => Effort::About,
        (Some("along"), _) => Effort::Along,
        (Some("line"), _) => Effort::Line,
        (None, Some(usual)) => usual,
        (found, _) => {
            let found = found.map_or("nothing".to_owned(), |found| format!("`{}`", found.escape_debug()));
            return Err(SceneError::value(format!("{key}.acts"), "`about`, `along` or `line`", found));
        }
    };
    let kind = if table.kind == "friction" {
        let speed = number(key, table.speed, "speed", None)?;
        if speed == 0.0 {
            return Err(SceneError::value(format!("{key}.speed"), "a positive speed", speed));
        }
        ElementKind::Friction(Friction {
            effort,
            limit: number(key, table.limit, "limit", None)?,
            speed,
            viscous: number(key, table.damping, "damping", Some(0.0))?,
        })
    } else {
        let Some(input) = &table.input else {
            return Err(SceneError::value(format!("{key}.input"), "a function of time", "nothing"));
        };
        let gain = table.gain.unwrap_or(1.0);
        if !gain.is_finite() {
            return Err(SceneError::value(format!("{key}.gain"), "a finite number", gain));
        }
        let limit = table.limit.map(|limit| number(key, Some(limit), "limit", None)).transpose()?;
        ElementKind::Actuator {
            actuator: Actuator { effort, gain, limit: limit.unwrap_or(f64::MAX) },
            input: function_of_time(&format!("{key}.input"), input, folder)?,
        }
    };
    Ok(Element { kind, first, second })
}

/// Both ends of a joint, and where an effort in it usually acts: on what the joint leaves free.
fn in_joint(
    key: &str,
    table: &ForceTable,
    name: &str,
    joints: &Joints<'_>,
) -> Result<(Attachment<f64>, Attachment<f64>, Option<Effort>), SceneError> {
    let places = [
        (table.first.is_some(), "first"),
        (table.second.is_some(), "second"),
        (table.axis.is_some(), "axis"),
        (table.first_position.is_some(), "first_position"),
        (table.second_position.is_some(), "second_position"),
    ];
    if let Some((_, what)) = places.into_iter().find(|(given, _)| *given) {
        let expected = "nothing: the joint has its own";
        return Err(SceneError::value(format!("{key}.{what}"), expected, "a value"));
    }
    let found = joints.names.iter().find(|(known, _)| known == name);
    let Some((connection, _)) = found.and_then(|(_, own)| joints.connections.get(*own.first()?)) else {
        return Err(SceneError::Unknown {
            key: format!("{key}.joint"),
            kind: "joint",
            found: name.escape_debug().to_string(),
            known: joints.names.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(", "),
        });
    };
    let usual = match connection.kind {
        JointKind::Revolute(_) => Some(Effort::About),
        JointKind::Prismatic(_) | JointKind::InLine(_) => Some(Effort::Along),
        _ => None,
    };
    Ok((connection.first, connection.second, usual))
}

fn number(key: &str, value: Option<f64>, what: &str, otherwise: Option<f64>) -> Result<f64, SceneError> {
    match value.or(otherwise) {
        Some(number) if number >= 0.0 && number.is_finite() => Ok(number),
        Some(number) => {
            Err(SceneError::value(format!("{key}.{what}"), "a number that is not negative", number))
        }
        None => Err(SceneError::value(format!("{key}.{what}"), "a number", "nothing")),
    }
}

fn vector(key: &str, value: Option<Vector>) -> Result<Vector3<f64>, SceneError> {
    match value {
        Some(value) if value.iter().all(|x| x.is_finite()) => Ok(value.into()),
        Some(value) => Err(SceneError::value(format!("{key}.value"), "finite numbers", format!("{value:?}"))),
        None => Err(SceneError::value(format!("{key}.value"), "three numbers", "nothing")),
    }
}

fn six(
    key: &str,
    what: &str,
    value: Option<[f64; 6]>,
    otherwise: Option<[f64; 6]>,
) -> Result<[f64; 6], SceneError> {
    match value.or(otherwise) {
        Some(list) if list.iter().all(|x| *x >= 0.0 && x.is_finite()) => Ok(list),
        Some(list) => Err(SceneError::value(
            format!("{key}.{what}"),
            "six numbers that are not negative",
            format!("{list:?}"),
        )),
        None => Err(SceneError::value(format!("{key}.{what}"), "six numbers", "nothing")),
    }
}

fn follows(key: &str, table: &ForceTable) -> Result<bool, SceneError> {
    match table.frame.as_deref() {
        None | Some("inertial") => Ok(false),
        Some("body") => Ok(true),
        Some(other) => Err(SceneError::value(
            format!("{key}.frame"),
            "`inertial` or `body`",
            format!("`{}`", other.escape_debug()),
        )),
    }
}
