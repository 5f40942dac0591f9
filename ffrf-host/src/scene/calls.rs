//! The calls of the macros that make a scene: its bodies and its mechanism, as code.
//!
//! What the macro does not have (formulas of time, inputs of actuators) stands in comments at its place.

use std::fmt::Write as _;
use std::path::{Component, Path, PathBuf};

use ffrf_codegen::{DEFAULT_LAYOUT_TOLERANCE, Fidelity, ScalarType};
use ffrf_model::ModeSelection;

use super::file::{BodyTable, ForceTable, FunctionValue, JointTable, SceneFile, Vector};
use super::{Scene, SceneModel};

/// A flexible body as a macro makes it.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyCall {
    /// Which modes of its model.
    pub modes: ModeSelection,
    /// How many they are.
    pub mode_count: usize,
    /// Terms of its kinetic energy.
    pub fidelity: Fidelity,
}

/// How a scene is made by macros.
#[derive(Debug, Clone, PartialEq)]
pub struct MacroCalls<'a> {
    /// Name of the mechanism.
    pub title: &'a str,
    /// For each body, none of rigid ones.
    pub bodies: &'a [Option<BodyCall>],
    /// Number type.
    pub scalar: ScalarType,
    /// Below which size, relative to its Gram scale, an entry of an invariant counts as zero.
    pub layout_tolerance: f64,
    /// The function with the accelerations of the whole mechanism, if there is one.
    pub accelerations: Option<&'a str>,
    /// The same for linearly implicit stages.
    pub implicit_accelerations: Option<&'a str>,
    /// The function that projects it onto its joints.
    pub projection: Option<&'a str>,
    /// The same after linearly implicit steps.
    pub implicit_projection: Option<&'a str>,
}

impl Scene {
    /// Its bodies as macros make them; `file`: where they stand.
    pub fn body_calls(&self, file: &SceneFile) -> Vec<Option<BodyCall>> {
        let bodies = file.bodies.iter().zip(&self.models);
        let call = |table: &BodyTable, SceneModel { model, fidelity }: &SceneModel| {
            let all = ModeSelection::First(model.mode_count());
            let modes = table.modes.as_ref().map_or(all, |modes| modes.0.clone());
            BodyCall { modes, mode_count: model.mode_count(), fidelity: fidelity.clone() }
        };
        bodies.map(|((_, table), model)| model.as_ref().map(|model| call(table, model))).collect()
    }
}

/// The calls. `folder`: that of the scene, from where the calls are to stand.
pub fn macro_calls(file: &SceneFile, folder: &Path, calls: &MacroCalls<'_>) -> String {
    let mut text = String::from(
        "// paths of models: from where this was made, which is to be the folder of Cargo.toml\n",
    );
    for ((name, table), call) in file.bodies.iter().zip(calls.bodies) {
        if let (Some(model), Some(call)) = (&table.model, call) {
            let _ = writeln!(text, "ffrf::flexible_body! {{\n    pub struct {} {{", camel(name));
            let _ =
                writeln!(text, "        model: {:?},\n        modes: {},", tidy(folder, model), call.modes);
            if call.fidelity != Fidelity::Full && call.mode_count > 0 {
                let _ = writeln!(text, "        fidelity: {},", call.fidelity);
            }
            if calls.scalar == ScalarType::F32 {
                text.push_str("        scalar: f32,\n");
            }
            if calls.layout_tolerance != DEFAULT_LAYOUT_TOLERANCE {
                let _ = writeln!(text, "        layout_tolerance: {:?},", calls.layout_tolerance);
            }
            text.push_str("    }\n}\n");
        }
    }
    let _ = writeln!(text, "ffrf::mechanism! {{\n    pub struct {} {{", camel(calls.title));
    let bodies = file.bodies.iter().zip(calls.bodies).map(|((name, table), call)| {
        let free = if is_held(file, name) { "" } else { "free " };
        format!("{name}: {free}{},", body(name, table, call.as_ref()))
    });
    section(&mut text, "bodies", bodies.collect());
    if file.simulation.gravity != [0.0; 3] {
        let _ = writeln!(text, "        gravity: {:?},", file.simulation.gravity);
    }
    section(&mut text, "joints", file.joints.iter().map(|(name, table)| joint(name, table)).collect());
    section(&mut text, "drives", file.joints.iter().filter_map(|(name, table)| drive(name, table)).collect());
    section(&mut text, "forces", file.forces.iter().map(|(name, table)| force(name, table)).collect());
    let sensors = file.sensors.iter().map(|(name, table)| match table.kind.as_str() {
        "stress" => format!("// {name}: at the stress marker {}, a constant of its body", table.of),
        kind => format!("{name}: {kind}({}),", table.of),
    });
    section(&mut text, "sensors", sensors.collect());
    if calls.scalar == ScalarType::F32 {
        text.push_str("        scalar: f32,\n");
    }
    let printed = [
        ("accelerations", calls.accelerations),
        ("implicit_accelerations", calls.implicit_accelerations),
        ("projection", calls.projection),
        ("implicit_projection", calls.implicit_projection),
    ];
    for (key, function) in printed {
        if let Some(function) = function {
            let _ = writeln!(text, "        {key}: {function},");
        }
    }
    text.push_str("    }\n}\n");
    text
}

fn section(text: &mut String, name: &str, lines: Vec<String>) {
    if lines.is_empty() {
        return;
    }
    let _ = writeln!(text, "        {name}: {{");
    for line in lines {
        let _ = writeln!(text, "            {line}");
    }
    text.push_str("        },\n");
}

/// Whether a joint ends on the body; what flies is said to.
fn is_held(file: &SceneFile, body: &str) -> bool {
    let on_body = |end: &String| end.split('.').next() == Some(body);
    file.joints.iter().any(|(_, table)| on_body(&table.first) || on_body(&table.second))
}

/// The path of a file that a scene names, without the folders that `..` leaves again, and with `/` everywhere.
fn tidy(folder: &Path, name: &str) -> String {
    let mut path = PathBuf::new();
    for part in folder.join(name).components() {
        match (part, path.components().next_back()) {
            (Component::CurDir, _) => {}
            (Component::ParentDir, Some(Component::Normal(_))) => {
                path.pop();
            }
            _ => path.push(part),
        }
    }
    path.display().to_string().replace(std::path::MAIN_SEPARATOR, "/")
}

fn body(name: &str, table: &BodyTable, call: Option<&BodyCall>) -> String {
    match (call.map(|call| call.mode_count), table.mass) {
        (Some(0), _) => format!("rigid {}", camel(name)),
        (Some(_), _) => camel(name),
        (None, mass) => {
            let mut text = format!("rigid {{ mass: {:?}", mass.unwrap_or(0.0));
            if let Some(center) = table.center_of_mass.filter(|center| *center != [0.0; 3]) {
                let _ = write!(text, ", center_of_mass: {center:?}");
            }
            if let Some(inertia) = table.inertia {
                let _ = write!(text, ", inertia: {inertia:?}");
            }
            if !table.markers.is_empty() {
                let markers = table.markers.iter().map(|(name, place)| format!("{name}: {place:?}"));
                let _ = write!(text, ", markers: {{ {} }}", markers.collect::<Vec<_>>().join(", "));
            }
            text + " }"
        }
    }
}

/// An end; a place on a body in its frame, or a marker of it.
fn end(name: &str, position: Option<Vector>) -> String {
    match position {
        None => name.to_owned(),
        Some(position) => format!("{name}.at({position:?})"),
    }
}

fn axis(axis: Option<Vector>, second: Option<Vector>) -> String {
    match (axis, second) {
        (None, None) => String::new(),
        (Some(axis), None) => format!(", axis: {axis:?}"),
        (axis, Some(second)) => format!(", axis: ({:?}, {second:?})", axis.unwrap_or([0.0, 0.0, 1.0])),
    }
}

fn joint(name: &str, table: &JointTable) -> String {
    let ends = [end(&table.first, table.first_position), end(&table.second, table.second_position)];
    let mut text =
        format!("{name}: {}({}, {}{}", table.kind, ends[0], ends[1], axis(table.axis, table.second_axis));
    if table.kind == "distance" {
        match table.length {
            Some(length) => {
                let _ = write!(text, ", length: {length:?}");
            }
            None => text.push_str(", /* length: the initial distance */"),
        }
    }
    for (what, held) in [("translation", table.translation), ("rotation", table.rotation)] {
        if let Some(held) = held {
            let _ = write!(text, ", {what}: {held:?}");
        }
    }
    text + "),"
}

fn drive(name: &str, table: &JointTable) -> Option<String> {
    let drive = table.drive.as_ref()?;
    let (kind, function) = match (&drive.angle, &drive.position) {
        (Some(angle), _) => ("angle", angle),
        (None, Some(position)) => ("position", position),
        (None, None) => return None,
    };
    Some(match function {
        FunctionValue::Polynomial(coefficients) => {
            format!("{name}_drive: {kind}({name}, polynomial: {coefficients:?}),")
        }
        FunctionValue::Text(formula) => {
            format!(
                "{name}_drive: {kind}({name}, function: {name}_motion), // value, rate, acceleration of {formula}"
            )
        }
    })
}

fn force(name: &str, table: &ForceTable) -> String {
    let first = end(table.first.as_deref().unwrap_or("ground"), table.first_position);
    let second = end(table.second.as_deref().unwrap_or("ground"), table.second_position);
    let number = |value: Option<f64>| value.unwrap_or(0.0);
    let constants = format!("stiffness: {:?}, damping: {:?}", number(table.stiffness), number(table.damping));
    let at = table.joint.clone().unwrap_or_else(|| format!("{first}, {second}{}", axis(table.axis, None)));
    match table.kind.as_str() {
        "spring" => {
            let rest = table.rest.map_or("/* rest_length: the initial one */".to_owned(), |rest| {
                format!("rest_length: {rest:?}")
            });
            format!("{name}: spring({first}, {second}, {constants}, {rest}),")
        }
        "torsion_spring" => {
            let rest = table.rest.map_or(String::new(), |rest| format!(", rest_angle: {rest:?}"));
            format!("{name}: torsion_spring({at}, {constants}{rest}),")
        }
        "bushing" => {
            let (stiffness, damping) =
                (table.stiffness_matrix.unwrap_or([0.0; 6]), table.damping_matrix.unwrap_or([0.0; 6]));
            format!("{name}: bushing({first}, {second}, stiffness: {stiffness:?}, damping: {damping:?}),")
        }
        "force" | "moment" => {
            let frame = table.frame.as_deref().unwrap_or("inertial");
            let value = table.value.unwrap_or([0.0; 3]);
            format!("{name}: {}({second}, value: {value:?}, frame: {frame}),", table.kind)
        }
        "friction" => {
            let mut text = format!("{name}: friction({at}");
            if let Some(acts) = &table.acts {
                let _ = write!(text, ", acts: {acts}");
            }
            let numbers = [
                ("limit", table.limit),
                ("coefficient", table.coefficient),
                ("radius", table.radius),
                ("speed", table.speed),
                ("viscous", table.damping),
            ];
            for (what, number) in numbers {
                if let Some(number) = number {
                    let _ = write!(text, ", {what}: {number:?}");
                }
            }
            text + "),"
        }
        "actuator" => format!("{name}: actuator({at}), // set its inputs between steps"),
        other => format!("// {name}: {other} is no part of the macro"),
    }
}

/// `connecting_rod` as the name of a type.
pub fn camel(name: &str) -> String {
    let words = name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let camel: String = words
        .map(|word| {
            let mut letters = word.chars();
            letters
                .next()
                .map(|first| first.to_uppercase().chain(letters).collect::<String>())
                .unwrap_or_default()
        })
        .collect();
    // a name of a type begins with a letter
    if camel.starts_with(|c: char| c.is_alphabetic()) { camel } else { format!("Scene{camel}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn models_are_named_from_where_the_scene_is_named() {
        assert_eq!(tidy(Path::new("models/scenes"), "../rod.json"), "models/rod.json");
        assert_eq!(tidy(Path::new("./scenes"), "../../rod.json"), "../rod.json");
        assert_eq!(tidy(Path::new(""), "rod.json"), "rod.json");
    }

    #[test]
    fn names_become_types() {
        assert_eq!(camel("connecting_rod"), "ConnectingRod");
        assert_eq!(camel("4-bar"), "Scene4Bar");
    }
}
