//! What `fmu.c` knows of its variables: counts, names and starts.

use std::fmt::Write as _;

use ffrf_codegen::mechanism::{MechanismModel, SensorKindModel};

use crate::model::Model;
use crate::parameter::Parameter;
use crate::variables::Role;

/// Constants and tables in C.
pub(super) fn tables(model: &Model, mechanism: &MechanismModel) -> String {
    let mut starts = Vec::new();
    let (mut inputs, mut columns, mut step) = (0, 0, 0);
    for variable in &model.variables {
        match variable.role {
            Role::Time => {}
            Role::Parameter(parameter, start) => {
                starts.push(start);
                if parameter == Parameter::Step {
                    step = starts.len();
                }
            }
            Role::Input(..) => inputs += 1,
            Role::Output(_) | Role::Local(_) => columns += 1,
        }
    }
    let modes: Vec<usize> = mechanism.bodies.iter().map(|body| body.kind.mode_count()).collect();
    let most = modes.iter().copied().max().unwrap_or(0);
    let (mut place, mut angles) = (0, Vec::new());
    for sensor in &mechanism.sensors {
        if matches!(sensor.kind, SensorKindModel::Turn(_)) {
            angles.push(place);
        }
        place += sensor.kind.width();
    }
    let mut text = String::from("enum {\n");
    for (name, count) in [
        ("VARIABLES", model.variables.len()),
        ("PARAMETERS", starts.len()),
        ("INPUTS", inputs),
        ("COLUMNS", columns),
        ("BODIES", modes.len()),
        ("ANGLES", angles.len()),
    ] {
        let _ = writeln!(text, "    {name} = {count},");
    }
    // which parameter is the step, counted from one
    let _ = write!(text, "    STEP_PARAMETER = {step}\n}};\n\n");
    let _ = write!(
        text,
        "#define SCENE_STEP {:?}\n#define HAS_SENSORS {}\n#define HAS_MODES {}\n#define INPUTS_ARE_THERE {}\n",
        mechanism.step,
        u8::from(!mechanism.sensors.is_empty()),
        u8::from(most > 0),
        u8::from(inputs > 0)
    );
    if most > 0 {
        let _ = writeln!(text, "#define MOST_MODES {most}");
        let _ = write!(text, "\nstatic const int modes[BODIES] = {};\n", list(&modes));
    }
    let numbers = |numbers: &[f64]| {
        let written: Vec<String> = numbers.iter().map(|number| format!("{number:?}")).collect();
        list(&written)
    };
    let _ = write!(text, "\nstatic const double parameter_starts[] = {};\n", numbers(&starts));
    if !mechanism.sensors.is_empty() {
        let _ = write!(
            text,
            "\n/* Where the angles of joints stand among the outputs. */\nstatic const int angles[] = {};\n",
            list(&angles)
        );
    }
    text.push_str(
        "\n/* Variables by their value references. */\nstatic const char *const names[VARIABLES] = {\n",
    );
    for variable in &model.variables {
        let _ = writeln!(text, "    \"{}\",", literal(&variable.name));
    }
    text.truncate(text.len() - 2);
    text.push_str("\n};\n");
    text
}

/// A list in braces; C has no empty ones.
fn list<T: ToString>(entries: &[T]) -> String {
    if entries.is_empty() {
        return "{0}".to_owned();
    }
    let mut text = String::from("{");
    let mut width = 0;
    for (index, entry) in entries.iter().enumerate() {
        let entry = entry.to_string();
        if index > 0 {
            text.push(',');
            let fits = width + entry.len() <= LONGEST;
            text.push_str(if fits { " " } else { "\n    " });
            width = if fits { width } else { 0 };
        }
        width += entry.len() + 2;
        text.push_str(&entry);
    }
    text.push('}');
    text
}

/// Of a line.
const LONGEST: usize = 100;

/// A text as it stands between quotes of C, in bytes that every compiler reads.
fn literal(text: &str) -> String {
    let mut written = String::with_capacity(text.len());
    for byte in text.bytes() {
        match byte {
            b'"' | b'\\' => written.extend(['\\', char::from(byte)]),
            b'?' | 0..=0x1f | 0x7f.. => {
                let _ = write!(written, "\\{byte:03o}");
            }
            other => written.push(char::from(other)),
        }
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_literals_of_c() {
        assert_eq!(literal("a\"\\ é?\n1"), "a\\\"\\\\ \\303\\251\\077\\0121");
        assert_eq!(list::<u8>(&[]), "{0}");
        assert_eq!(list(&[1, 2]), "{1, 2}");
    }
}
