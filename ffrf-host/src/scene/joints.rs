//! Joints of a scene: their kinds, triads and drives.

use std::path::Path;

use ffrf_codegen::mechanism::{KNOWN_JOINTS, KnownJoint};
use ffrf_runtime::joints::{
    Angle, ConstantOrientation, Cylindrical, Distance, Fixed, Generic, InLine, InPlane, JointKind, Planar,
    Prismatic, Revolute, Spherical, Travel, Universal,
};
use ffrf_runtime::mechanism::{Attachment, Connection, along_axis, second_triad};
use ffrf_runtime::{MarkerMotion, PlacedMarker, State};
use nalgebra::{UnitQuaternion, Vector3};

use super::SceneError;
use super::file::{FunctionValue, JointTable, Vector};
use super::names::{NamedBody, attachment, different};
use crate::HostModal;
use crate::mechanism::{Drive, Formula, Table};

/// A joint as composed: its connection, and that of its drive.
pub(super) struct ComposedJoint {
    pub(super) connection: Connection<f64>,
    pub(super) drive: Option<(Connection<f64>, Drive)>,
}

/// The joint of a table between bodies in their initial states.
pub(super) fn joint(
    name: &str,
    table: &JointTable,
    bodies: &mut [NamedBody],
    states: &[State<HostModal>],
    folder: &Path,
) -> Result<ComposedJoint, SceneError> {
    let key = format!("joints.{name}");
    let mut first = attachment(bodies, &format!("{key}.first"), &table.first, table.first_position)?;
    let mut second = attachment(bodies, &format!("{key}.second"), &table.second, table.second_position)?;
    different(&key, bodies, [&first, &second])?;
    let ends = [triad(bodies, states, &first), triad(bodies, states, &second)];
    let kind = kind(&key, table, &ends)?;
    let to_axis = direction(&format!("{key}.axis"), table.axis)?;
    first.orientation *= to_axis;
    second.orientation *= match kind {
        JointKind::Universal(_) => second_axis(&key, table, &ends, &to_axis)?,
        _ => second_triad(&kind, [&ends[0].orientation, &ends[1].orientation], &to_axis),
    };
    let connection = Connection { kind, first, second };
    let drive = match &table.drive {
        None => None,
        Some(drive) => {
            let key = format!("{key}.drive");
            let (kind, function) = match (&drive.angle, &drive.position) {
                (Some(angle), None) => (JointKind::Angle(Angle), angle),
                (None, Some(position)) => (JointKind::Travel(Travel), position),
                _ => return Err(SceneError::value(key, "either `angle` or `position`", "both or neither")),
            };
            let can = |known: &KnownJoint| match kind {
                JointKind::Angle(_) => known.has_angle,
                _ => known.has_travel,
            };
            if !KnownJoint::find(&table.kind).is_some_and(can) {
                return Err(SceneError::value(
                    key,
                    "an angle of a revolute or cylindrical joint, or a position of a prismatic, cylindrical or in_line one",
                    format!("a joint of kind `{}`", table.kind),
                ));
            }
            Some((Connection { kind, first, second }, function_of_time(&key, function, folder)?))
        }
    };
    Ok(ComposedJoint { connection, drive })
}

/// The triad that an attachment has in the initial state.
pub(super) fn triad(
    bodies: &[NamedBody],
    states: &[State<HostModal>],
    attachment: &Attachment<f64>,
) -> MarkerMotion {
    let Some(body) = attachment.body else {
        return MarkerMotion::fixed(attachment.position, attachment.orientation);
    };
    let motion =
        PlacedMarker::new(&bodies[body].markers[attachment.marker], &states[body]).motion(&states[body]);
    motion.turned(&attachment.orientation)
}

fn kind(key: &str, table: &JointTable, ends: &[MarkerMotion; 2]) -> Result<JointKind, SceneError> {
    let only = |given: bool, what: &str, kinds: &str| {
        if given {
            Err(SceneError::value(format!("{key}.{what}"), format!("nothing: {kinds} only"), "a value"))
        } else {
            Ok(())
        }
    };
    only(table.length.is_some() && table.kind != "distance", "length", "distance joints")?;
    only(table.second_axis.is_some() && table.kind != "universal", "second_axis", "universal joints")?;
    let held = table.translation.is_some() || table.rotation.is_some();
    only(held && table.kind != "generic", "translation and rotation", "generic joints")?;
    Ok(match table.kind.as_str() {
        "fixed" => JointKind::Fixed(Fixed),
        "revolute" => JointKind::Revolute(Revolute),
        "spherical" => JointKind::Spherical(Spherical),
        "universal" => JointKind::Universal(Universal),
        "cylindrical" => JointKind::Cylindrical(Cylindrical),
        "prismatic" => JointKind::Prismatic(Prismatic),
        "planar" => JointKind::Planar(Planar),
        "in_line" => JointKind::InLine(InLine),
        "in_plane" => JointKind::InPlane(InPlane),
        "constant_orientation" => JointKind::ConstantOrientation(ConstantOrientation),
        "distance" => {
            let length = table.length.unwrap_or_else(|| (ends[1].position - ends[0].position).norm());
            if !(length > 0.0 && length.is_finite()) {
                return Err(SceneError::value(format!("{key}.length"), "a positive length", length));
            }
            JointKind::Distance(Distance { length })
        }
        "generic" => {
            let (translation, rotation) =
                (table.translation.unwrap_or([false; 3]), table.rotation.unwrap_or([false; 3]));
            if !translation.iter().chain(&rotation).any(|held| *held) {
                return Err(SceneError::value(key, "a translation or rotation that is held", "none"));
            }
            JointKind::Generic(Generic { translation, rotation })
        }
        other => {
            return Err(SceneError::Unknown {
                key: format!("{key}.kind"),
                kind: "kind of joint",
                found: other.escape_debug().to_string(),
                known: KNOWN_JOINTS.map(|joint| joint.name).join(", "),
            });
        }
    })
}

/// The rotation that takes z to an axis; none for z itself.
pub(super) fn direction(key: &str, axis: Option<Vector>) -> Result<UnitQuaternion<f64>, SceneError> {
    let Some(axis) = axis else { return Ok(UnitQuaternion::identity()) };
    let vector = Vector3::from(axis);
    let norm = vector.norm();
    if !(norm > 0.0 && norm.is_finite()) {
        return Err(SceneError::value(key, "a direction", format!("{axis:?}")));
    }
    Ok(along_axis(&vector))
}

/// The second triad of a universal joint: z along the second axis, by default the one that is x of the first triad now.
fn second_axis(
    key: &str,
    table: &JointTable,
    ends: &[MarkerMotion; 2],
    along_axis: &UnitQuaternion<f64>,
) -> Result<UnitQuaternion<f64>, SceneError> {
    let axis = table.second_axis.unwrap_or_else(|| {
        let x = ends[0].orientation * (along_axis * Vector3::x());
        ends[1].orientation.inverse_transform_vector(&x).into()
    });
    direction(&format!("{key}.second_axis"), Some(axis))
}

/// A polynomial, a formula, or a table in a file beside the scene.
pub(super) fn function_of_time(
    key: &str,
    function: &FunctionValue,
    folder: &Path,
) -> Result<Drive, SceneError> {
    match function {
        FunctionValue::Polynomial(coefficients) => {
            if coefficients.is_empty() || coefficients.iter().any(|c| !c.is_finite()) {
                return Err(SceneError::value(
                    key,
                    "finite coefficients, at least one",
                    format!("{coefficients:?}"),
                ));
            }
            Ok(Drive::Polynomial(coefficients.clone()))
        }
        FunctionValue::Text(text) => {
            let path = folder.join(text);
            let is_table = [".csv", ".txt", ".dat"].iter().any(|ending| text.ends_with(ending));
            if is_table || path.is_file() {
                let content = std::fs::read_to_string(&path).map_err(|source| SceneError::Key {
                    key: key.to_owned(),
                    message: format!("{}: {source}", path.display()),
                })?;
                return Table::parse(&content).map(Drive::Table).map_err(|error| SceneError::Key {
                    key: key.to_owned(),
                    message: format!("{}: {error}", path.display()),
                });
            }
            Formula::parse(text)
                .map(Drive::Formula)
                .map_err(|error| SceneError::Key { key: key.to_owned(), message: error.to_string() })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_known_joint_can_stand_in_a_scene() {
        let place = |x: f64| MarkerMotion::fixed(Vector3::new(x, 0.0, 0.0), UnitQuaternion::identity());
        for known in &KNOWN_JOINTS {
            let held = if known.rows.is_none() { "translation = [true, false, false]" } else { "" };
            let text = format!("kind = \"{}\"\nfirst = \"ground\"\nsecond = \"body\"\n{held}", known.name);
            let table: JointTable = toml::from_str(&text).unwrap();
            let found = kind("joints.one", &table, &[place(0.0), place(1.0)]).unwrap();
            assert_eq!(found.row_count(), known.rows.unwrap_or(1), "{}", known.name);
            assert!(format!("{found:?}").starts_with(known.type_name), "{found:?}");
        }
    }
}
