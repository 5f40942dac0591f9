//! A scene as the text of `mechanism!`, for a program on the target; names are replaced by numbers.

use std::fmt::Write;

use anyhow::{Result, bail};
use ffrf_host::mechanism::ElementKind;
use ffrf_host::scene::file::{ForceTable, FunctionValue, JointTable, SceneFile, Vector};
use ffrf_host::scene::{ModesValue, Scene};

/// The type of each body: `None` where numbers in the macro say everything.
pub type BodyTypes = [Option<String>];

/// The invocation of the macro that makes `pub struct Model` of the scene. `accelerations`: a function beside it that gives them.
///
/// Errors: something in the scene has no counterpart in the macro.
pub fn invocation(
    file: &SceneFile,
    scene: &Scene,
    types: &BodyTypes,
    scalar: &str,
    accelerations: Option<&str>,
) -> Result<String> {
    let writer = Writer { file, scene };
    let mut text =
        String::from("ffrf::mechanism! {\n    /// The scene.\n    pub struct Model {\n        bodies: {\n");
    let numbered = file.bodies.iter().zip(types).enumerate();
    for (number, ((name, table), type_name)) in numbered {
        let free = if writer.is_held(name) { "" } else { "free " };
        let _ = match (type_name, table.mass, table.inertia) {
            (Some(type_name), ..) => {
                let rigid =
                    if table.modes.as_ref().is_some_and(ModesValue::is_rigid) { "rigid " } else { "" };
                writeln!(text, "            body_{number}: {free}{rigid}{type_name},")
            }
            (None, Some(mass), Some(inertia)) => writeln!(
                text,
                "            body_{number}: {free}rigid {{ mass: {mass:?}, center_of_mass: {:?}, inertia: {inertia:?} }},",
                table.center_of_mass.unwrap_or_default()
            ),
            _ => bail!("bodies: expected a model, or mass and inertia"),
        };
    }
    let _ =
        writeln!(text, "        }},\n        gravity: {:?},\n        joints: {{", file.simulation.gravity);
    for (number, (_, table)) in file.joints.iter().enumerate() {
        let _ = writeln!(text, "            joint_{number}: {},", writer.joint(table)?);
    }
    text.push_str("        },\n        drives: {\n");
    for (number, (name, table)) in file.joints.iter().enumerate() {
        if let Some(drive) = &table.drive {
            let (kind, function) = match (&drive.angle, &drive.position) {
                (Some(angle), _) => ("angle", angle),
                (None, Some(position)) => ("position", position),
                (None, None) => continue,
            };
            let FunctionValue::Polynomial(coefficients) = function else {
                bail!("joints.{name}.drive: expected a polynomial; formulas and tables run on the host only");
            };
            let _ = writeln!(
                text,
                "            drive_{number}: {kind}(joint_{number}, polynomial: {coefficients:?}),"
            );
        }
    }
    text.push_str("        },\n        forces: {\n");
    for (number, (name, table)) in file.forces.iter().enumerate() {
        let _ = writeln!(text, "            force_{number}: {},", writer.force(name, table)?);
    }
    text.push_str("        },\n");
    if let Some(function) = accelerations {
        let _ = writeln!(text, "        accelerations: crate::{function},");
    }
    let _ = writeln!(text, "        scalar: {scalar},\n    }}\n}}");
    Ok(text)
}

struct Writer<'a> {
    file: &'a SceneFile,
    scene: &'a Scene,
}

impl Writer<'_> {
    fn body(&self, name: &str) -> Result<usize> {
        match self.file.bodies.iter().position(|(body, _)| body == name) {
            Some(number) => Ok(number),
            None => bail!("unknown body `{name}`"),
        }
    }

    /// Whether a joint ends on the body; what flies is said to.
    fn is_held(&self, body: &str) -> bool {
        let on_body = |end: &String| end.split('.').next() == Some(body);
        self.file.joints.iter().any(|(_, table)| on_body(&table.first) || on_body(&table.second))
    }

    fn end(&self, name: &str, position: Option<Vector>) -> Result<String> {
        if name == "ground" {
            return Ok(position.map_or_else(|| name.to_owned(), |at| format!("ground.at({at:?})")));
        }
        let Some((body, marker)) = name.split_once('.') else {
            let number = self.body(name)?;
            let at = position.map_or_else(String::new, |at| format!(".at({at:?})"));
            return Ok(format!("body_{number}{at}"));
        };
        let number = self.body(body)?;
        let table = &self.file.bodies[number].1;
        let offset = position.unwrap_or_default();
        if let Some(at) = table.markers.get(marker) {
            let at = std::array::from_fn::<_, 3, _>(|i| at[i] + offset[i]);
            return Ok(format!("body_{number}.at({at:?})"));
        }
        if offset != [0.0; 3] {
            bail!("`{name}`: a point beside a marker of a flexible body has no counterpart in the macro");
        }
        let constant: String = marker
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' })
            .collect();
        Ok(format!("body_{number}.{constant}"))
    }

    fn joint(&self, table: &JointTable) -> Result<String> {
        let first = self.end(&table.first, table.first_position)?;
        let second = self.end(&table.second, table.second_position)?;
        let mut text = format!("{}({first}, {second}", table.kind);
        match (table.axis, table.second_axis) {
            (axis, Some(second)) => {
                let _ = write!(text, ", axis: ({:?}, {second:?})", axis.unwrap_or([0.0, 0.0, 1.0]));
            }
            (Some(axis), None) => {
                let _ = write!(text, ", axis: {axis:?}");
            }
            (None, None) => {}
        }
        if table.kind == "distance" {
            let Some(length) = table.length else {
                bail!("a distance joint: expected its `length`");
            };
            let _ = write!(text, ", length: {length:?}");
        }
        if table.kind == "generic" {
            let held = |held: Option<[bool; 3]>| held.unwrap_or_default();
            let _ = write!(
                text,
                ", translation: {:?}, rotation: {:?}",
                held(table.translation),
                held(table.rotation)
            );
        }
        text.push(')');
        Ok(text)
    }

    fn force(&self, name: &str, table: &ForceTable) -> Result<String> {
        let ends = || -> Result<String> {
            let first = self.end(table.first.as_deref().unwrap_or("ground"), table.first_position)?;
            Ok(format!(
                "{first}, {}",
                self.end(table.second.as_deref().unwrap_or("ground"), table.second_position)?
            ))
        };
        let axis = table.axis.map_or_else(String::new, |axis| format!(", axis: {axis:?}"));
        let place = self.scene.element_names.iter().position(|element| element == name);
        let element =
            place.and_then(|place| self.scene.mechanism.elements().get(place)).map(|element| &element.kind);
        Ok(match (table.kind.as_str(), element) {
            ("spring", Some(ElementKind::Spring(spring))) => format!(
                "spring({}, stiffness: {:?}, damping: {:?}, rest_length: {:?})",
                ends()?,
                spring.stiffness,
                spring.damping,
                spring.rest_length
            ),
            ("torsion_spring", Some(ElementKind::TorsionSpring(spring))) => format!(
                "torsion_spring({}, stiffness: {:?}, damping: {:?}, rest_angle: {:?}{axis})",
                ends()?,
                spring.stiffness,
                spring.damping,
                spring.rest_angle
            ),
            ("bushing", Some(ElementKind::Bushing(bushing))) => format!(
                "bushing({}, stiffness: {:?}, damping: {:?})",
                ends()?,
                bushing.stiffness,
                bushing.damping
            ),
            ("force" | "moment", _) => {
                let end = self.end(table.second.as_deref().unwrap_or("ground"), table.second_position)?;
                let frame = table.frame.as_deref().unwrap_or("inertial");
                format!("{}({end}, value: {:?}, frame: {frame})", table.kind, table.value.unwrap_or_default())
            }
            ("actuator", _) if table.joint.is_some() => {
                let joint = table.joint.as_deref().unwrap_or_default();
                match self.file.joints.iter().position(|(name, _)| name == joint) {
                    Some(number) => format!("actuator(joint_{number})"),
                    None => bail!("forces.{name}.joint: unknown joint `{joint}`"),
                }
            }
            (kind, _) => bail!("forces.{name}: `{kind}` between these ends has no counterpart in the macro"),
        })
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn models(name: &str) -> std::path::PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(name)
    }

    #[test]
    fn a_scene_is_written_as_the_macro_wants_it() {
        let path = models("slider_crank.toml");
        let (file, scene) = (SceneFile::read(&path).unwrap(), Scene::read(&path).unwrap());
        let text =
            invocation(&file, &scene, &[None, Some("Body0".to_owned()), None], "f32", Some("ahead")).unwrap();
        for line in [
            "body_0: rigid { mass: 0.5, center_of_mass: [0.01, 0.0, 0.0], inertia: [[0.0002, 0.0, 0.0], ",
            "body_1: Body0,",
            "joint_0: revolute(ground, body_0, axis: [0.0, 0.0, 1.0]),",
            "joint_1: revolute(body_0.at([0.04, 0.0, 0.0]), body_1.BIG_END, axis: [0.0, 0.0, 1.0]),",
            "joint_2: spherical(body_1.SMALL_END, body_2),",
            "drive_0: angle(joint_0, polynomial: [0.0, 100.0]),",
            "gravity: [0.0, 0.0, -9.81],",
            "accelerations: crate::ahead,",
            "scalar: f32,",
        ] {
            assert!(text.contains(line), "{line} in\n{text}");
        }
    }

    #[test]
    fn what_the_macro_does_not_know_is_refused() {
        let path = models("slider_crank.toml");
        let text = std::fs::read_to_string(&path).unwrap().replace("[0.0, 100.0] }", "\"100 * t\" }");
        let (file, scene) = (SceneFile::parse(&text).unwrap(), Scene::read(&path).unwrap());
        let error =
            invocation(&file, &scene, &[None, Some("Body0".to_owned()), None], "f64", None).unwrap_err();
        assert!(error.to_string().contains("joints.main.drive: expected a polynomial"), "{error}");
    }
}
