//! The body's own numbers and its markers.

use ffrf_model::{Marker, ReducedBody, StressMarker};

use super::Style;
use super::notation::number;
use super::text::{Text, braced};
use crate::ScalarType;
use crate::emit::Subject;
use crate::emit::documentation::plain;
use crate::emit::markers::constant_names;

/// Names of constants, which no marker can take.
const RESERVED: [&str; 5] = ["MODE_COUNT", "VELOCITY_COUNT", "MASS", "LARGEST_STABLE_STEP", "H"];

/// Writes counts and numbers.
pub(super) fn constants(text: &mut Text, subject: &Subject<'_>, style: &Style) {
    let (prefix, modes) = (&style.macro_prefix, style.mode_count);
    text.documentation(["Number of modes M, and of velocities 6 + M.".to_owned()]);
    text.line(format!("#define {prefix}_MODE_COUNT {modes}"));
    text.line(format!("#define {prefix}_VELOCITY_COUNT {}", 6 + modes));
    let Some(model) = subject.model else { return };
    text.documentation(["Mass m. Units: kg.".to_owned()]);
    text.line(format!("#define {prefix}_MASS {}", number(model.inertia.mass, style.scalar)));
    if let Some(step) = model.largest_stable_step().filter(|step| step.is_finite()) {
        text.documentation([
            "Largest step with which the classical Runge-Kutta method of order four is stable for small motions of the"
                .to_owned(),
            "free body. Units: s.".to_owned(),
        ]);
        text.line(format!("#define {prefix}_LARGEST_STABLE_STEP {}", number(step, ScalarType::F64)));
    }
    text.blank();
}

/// Writes the type of markers and what there is.
pub(super) fn declarations(text: &mut Text, subject: &Subject<'_>, style: &Style) {
    let Some(model) = subject.model else { return };
    let [names, stress_names] = constant_names(model, &RESERVED);
    stress_declarations(text, model, &stress_names, style);
    if model.markers.is_empty() {
        return;
    }
    let (prefix, kind, modes) = (&style.prefix, style.type_name(), style.mode_count);
    text.documentation([
        "A marker. Units: m, and per unit modal coordinate; a row for each axis. Frame: body.".to_owned(),
    ]);
    text.block("typedef struct {", &format!("}} {prefix}_marker;\n"), |text| {
        text.line(format!("{kind} position[3];"));
        if modes > 0 {
            text.line(format!("{kind} translation[3][{modes}];\n{kind} rotation[3][{modes}];"));
        }
    });
    for (marker, name) in model.markers.iter().zip(names) {
        text.documentation([format!("Marker `{}`.", plain(&marker.name))]);
        text.line(format!("extern const {prefix}_marker {}_{name};", style.macro_prefix));
    }
    text.blank();
}

/// Writes the numbers of the markers.
pub(super) fn definitions(text: &mut Text, subject: &Subject<'_>, style: &Style) {
    let Some(model) = subject.model else { return };
    let [names, stress_names] = constant_names(model, &RESERVED);
    for (marker, name) in model.markers.iter().zip(names) {
        let head = format!("const {}_marker {}_{name} = {{", style.prefix, style.macro_prefix);
        text.block(&head, "};\n", |text| numbers(text, marker, style));
    }
    for (marker, name) in model.stress_markers.iter().zip(stress_names) {
        let head = format!("const {}_stress_marker {}_{name} = {{", style.prefix, style.macro_prefix);
        text.block(&head, "};\n", |text| stress_numbers(text, marker, style));
    }
}

fn stress_declarations(text: &mut Text, model: &ReducedBody, names: &[String], style: &Style) {
    if model.stress_markers.is_empty() {
        return;
    }
    let (prefix, kind, modes) = (&style.prefix, style.type_name(), style.mode_count);
    text.documentation([
        "A stress marker: rows xx, yy, zz, xy, xz, yz, to be multiplied by q. Units: m; N/m² per unit modal coordinate."
            .to_owned(),
    ]);
    text.block("typedef struct {", &format!("}} {prefix}_stress_marker;\n"), |text| {
        text.line(format!("{kind} position[3];"));
        if modes > 0 {
            text.line(format!("{kind} stress[6][{modes}];"));
        }
    });
    for (marker, name) in model.stress_markers.iter().zip(names) {
        text.documentation([format!("Stress marker `{}`.", plain(&marker.name))]);
        text.line(format!("extern const {prefix}_stress_marker {}_{name};", style.macro_prefix));
    }
    text.blank();
}

fn stress_numbers(text: &mut Text, marker: &StressMarker, style: &Style) {
    let list = |values: &mut dyn Iterator<Item = f64>| {
        braced(&values.map(|value| number(value, style.scalar)).collect::<Vec<_>>())
    };
    let position = list(&mut marker.position.into_iter());
    if style.mode_count == 0 {
        text.line(position);
        return;
    }
    text.line(format!("{position},"));
    text.block("{", "}", |text| {
        for component in 0..6 {
            let comma = if component < 5 { "," } else { "" };
            let row = list(&mut marker.stress.iter().map(|stress| stress[component]));
            text.line(format!("{row}{comma}"));
        }
    });
}

fn numbers(text: &mut Text, marker: &Marker, style: &Style) {
    let list = |values: &mut dyn Iterator<Item = f64>| {
        braced(&values.map(|value| number(value, style.scalar)).collect::<Vec<_>>())
    };
    let position = list(&mut marker.position.into_iter());
    if style.mode_count == 0 {
        text.line(position);
        return;
    }
    text.line(format!("{position},"));
    for (shapes, end) in [(&marker.translation, "},"), (&marker.rotation, "}")] {
        text.block("{", end, |text| {
            for axis in 0..3 {
                let comma = if axis < 2 { "," } else { "" };
                text.line(format!("{}{comma}", list(&mut shapes.iter().map(|shape| shape[axis]))));
            }
        });
    }
}
