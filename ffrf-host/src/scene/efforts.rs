//! Friction and actuators of a scene: single forces or moments in joints.

use std::path::Path;

use ffrf_runtime::forces::{Effort, Friction};
use ffrf_runtime::joints::JointKind;
use ffrf_runtime::mechanism::{Attachment, Connection, JointFriction};

use super::SceneError;
use super::file::ForceTable;
use super::joints::{direction, function_of_time};
use super::names::{NamedBody, attachment, different};
use crate::mechanism::{Drive, Element, ElementKind, ScheduledActuator};

/// What a table of forces makes.
pub(super) enum Composed {
    /// Acts in its motion.
    Element(Element),
    /// Follows the reaction of its joint.
    Friction(JointFriction),
    /// Acts as its input over time says.
    Actuator(ScheduledActuator),
}

/// The joints of a scene, in which friction and actuators act.
pub(super) struct Joints<'a> {
    /// Names, and the connections of each.
    pub(super) names: &'a [(String, Vec<usize>)],
    pub(super) connections: &'a [(Connection<f64>, Option<Drive>)],
}

/// Friction or an actuator, in a joint or between two attachments of its own.
pub(super) fn effort(
    key: &str,
    table: &ForceTable,
    bodies: &mut [NamedBody],
    joints: &Joints<'_>,
    folder: &Path,
) -> Result<Composed, SceneError> {
    let (InJoint { joint, ends: [first, second] }, usual) = match &table.joint {
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
            different(key, bodies, [&first, &second])?;
            (InJoint { joint: None, ends: [first, second] }, None)
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
    if table.kind == "friction" {
        let speed = number(key, table.speed, "speed", None)?;
        if speed == 0.0 {
            return Err(SceneError::value(format!("{key}.speed"), "a positive speed", speed));
        }
        let coefficient = table.coefficient.map(|c| number(key, Some(c), "coefficient", None)).transpose()?;
        let kind = Friction {
            effort,
            limit: number(key, table.limit, "limit", coefficient.map(|_| 0.0))?,
            speed,
            viscous: number(key, table.damping, "damping", Some(0.0))?,
        };
        let arm = arm(key, table, effort)?;
        match (coefficient, joint) {
            (None, _) => Ok(Composed::Element(Element { kind: ElementKind::Friction(kind), first, second })),
            (Some(coefficient), Some(joint)) => {
                Ok(Composed::Friction(JointFriction { joint, kind, coefficient, arm }))
            }
            (Some(_), None) => {
                let expected = "the joint whose reaction it follows, with `coefficient`";
                Err(SceneError::value(format!("{key}.joint"), expected, "nothing"))
            }
        }
    } else {
        let Some(input) = &table.input else {
            return Err(SceneError::value(format!("{key}.input"), "a function of time", "nothing"));
        };
        let gain = table.gain.unwrap_or(1.0);
        if !gain.is_finite() {
            return Err(SceneError::value(format!("{key}.gain"), "a finite number", gain));
        }
        let limit = table.limit.map(|limit| number(key, Some(limit), "limit", None)).transpose()?;
        let input = function_of_time(&format!("{key}.input"), input, folder)?;
        let limit = limit.unwrap_or(f64::MAX);
        Ok(Composed::Actuator(ScheduledActuator { effort, input, added: 0.0, gain, limit, first, second }))
    }
}

/// What the force of friction becomes its effort by: the radius of a bearing, where it acts about the axis.
fn arm(key: &str, table: &ForceTable, effort: Effort) -> Result<f64, SceneError> {
    let radius = format!("{key}.radius");
    match (table.radius, table.coefficient.is_some() && effort == Effort::About) {
        (None, false) => Ok(1.0),
        (Some(value), true) if value > 0.0 && value.is_finite() => Ok(value),
        (Some(value), true) => Err(SceneError::value(radius, "a positive radius", value)),
        (None, true) => {
            Err(SceneError::value(radius, "the radius of the bearing (m), with `coefficient`", "nothing"))
        }
        (Some(_), false) => {
            let expected = "nothing: it is for friction about an axis with a `coefficient`";
            Err(SceneError::value(radius, expected, "a value"))
        }
    }
}

/// Both ends of an element, and the joint that it is in.
struct InJoint {
    joint: Option<usize>,
    ends: [Attachment<f64>; 2],
}

/// Both ends of a joint, and where an effort in it usually acts: on what the joint leaves free.
fn in_joint(
    key: &str,
    table: &ForceTable,
    name: &str,
    joints: &Joints<'_>,
) -> Result<(InJoint, Option<Effort>), SceneError> {
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
    let own = found.and_then(|(_, own)| own.first().copied());
    let Some((connection, _)) = own.and_then(|own| joints.connections.get(own)) else {
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
    Ok((InJoint { joint: own, ends: [connection.first, connection.second] }, usual))
}

/// A number that is not negative, or what stands for none.
pub(super) fn number(
    key: &str,
    value: Option<f64>,
    what: &str,
    otherwise: Option<f64>,
) -> Result<f64, SceneError> {
    match value.or(otherwise) {
        Some(number) if number >= 0.0 && number.is_finite() => Ok(number),
        Some(number) => {
            Err(SceneError::value(format!("{key}.{what}"), "a number that is not negative", number))
        }
        None => Err(SceneError::value(format!("{key}.{what}"), "a number", "nothing")),
    }
}
