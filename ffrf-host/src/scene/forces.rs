//! Force elements of a scene.

use ffrf_runtime::State;
use ffrf_runtime::forces::{Bushing, ConstantWrench, Frame, Spring, TorsionSpring, relative_angle};
use ffrf_runtime::mechanism::turn_about;
use nalgebra::Vector3;

use super::SceneError;
use super::file::{ForceTable, Vector};
use super::joints::{direction, triad};
use super::names::{NamedBody, attachment};
use crate::HostModal;
use crate::mechanism::{Element, ElementKind};

/// Every kind of force element by its name in scene files.
const KINDS: [&str; 5] = ["spring", "torsion_spring", "bushing", "force", "moment"];

/// The force element of a table between bodies in their initial states.
pub(super) fn element(
    name: &str,
    table: &ForceTable,
    bodies: &mut [NamedBody],
    states: &[State<HostModal>],
) -> Result<Element, SceneError> {
    let key = format!("forces.{name}");
    let Some(second) = &table.second else {
        return Err(SceneError::value(format!("{key}.second"), "BODY or BODY.MARKER", "nothing"));
    };
    let first = table.first.as_deref().unwrap_or("ground");
    let mut first = attachment(bodies, &format!("{key}.first"), first, table.first_position)?;
    let mut second = attachment(bodies, &format!("{key}.second"), second, table.second_position)?;
    let number = |value: Option<f64>, what: &str, otherwise: Option<f64>| match value.or(otherwise) {
        Some(number) if number >= 0.0 && number.is_finite() => Ok(number),
        Some(number) => {
            Err(SceneError::value(format!("{key}.{what}"), "a number that is not negative", number))
        }
        None => Err(SceneError::value(format!("{key}.{what}"), "a number", "nothing")),
    };
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
        other => {
            return Err(SceneError::Unknown {
                key: format!("{key}.kind"),
                kind: "kind of force",
                found: other.escape_debug().to_string(),
                known: KINDS.join(", "),
            });
        }
    };
    Ok(Element { kind, first, second })
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
