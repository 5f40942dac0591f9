//! Force elements of a scene.

use std::path::Path;

use ffrf_runtime::State;
use ffrf_runtime::forces::{Bushing, ConstantWrench, Frame, Spring, TorsionSpring, relative_angle};
use ffrf_runtime::mechanism::turn_about;
use nalgebra::Vector3;

use super::SceneError;
use super::efforts::{Composed, Joints, effort, number};
use super::file::{ForceTable, Vector};
use super::joints::{direction, triad};
use super::names::{NamedBody, attachment, different};
use crate::HostModal;
use crate::mechanism::{Element, ElementKind};

/// Every kind of force element by its name in scene files.
const KINDS: [&str; 7] = ["spring", "torsion_spring", "bushing", "friction", "actuator", "force", "moment"];

/// The force of a table between bodies in their initial states.
pub(super) fn element(
    name: &str,
    table: &ForceTable,
    bodies: &mut [NamedBody],
    states: &[State<HostModal>],
    joints: &Joints<'_>,
    folder: &Path,
) -> Result<Composed, SceneError> {
    let key = format!("forces.{name}");
    used(&key, table)?;
    if matches!(table.kind.as_str(), "friction" | "actuator") {
        return effort(&key, table, bodies, joints, folder);
    }
    let Some(second) = &table.second else {
        return Err(SceneError::value(format!("{key}.second"), "BODY or BODY.MARKER", "nothing"));
    };
    let first = table.first.as_deref().unwrap_or("ground");
    let mut first = attachment(bodies, &format!("{key}.first"), first, table.first_position)?;
    let mut second = attachment(bodies, &format!("{key}.second"), second, table.second_position)?;
    different(&key, bodies, [&first, &second])?;
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
            let turn = turn_about(&relative, &along_axis);
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
        "force" => ElementKind::Constant(ConstantWrench {
            force: vector(&key, table.value)?,
            moment: Vector3::zeros(),
            frame: frame(&key, table)?,
        }),
        "moment" => ElementKind::Constant(ConstantWrench {
            force: Vector3::zeros(),
            moment: vector(&key, table.value)?,
            frame: frame(&key, table)?,
        }),
        _ => return Err(unknown_kind(&key, table)),
    };
    Ok(Composed::Element(Element { kind, first, second }))
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
        (table.coefficient.is_some(), "coefficient", &["friction"]),
        (table.radius.is_some(), "radius", &["friction"]),
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

fn frame(key: &str, table: &ForceTable) -> Result<Frame, SceneError> {
    match table.frame.as_deref() {
        None | Some("inertial") => Ok(Frame::Inertial),
        Some("body") => Ok(Frame::Body),
        Some(other) => Err(SceneError::value(
            format!("{key}.frame"),
            "`inertial` or `body`",
            format!("`{}`", other.escape_debug()),
        )),
    }
}
