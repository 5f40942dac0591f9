//! The body's own numbers and its markers.

use ffrf_model::Marker;

use super::Style;
use super::notation::number;
use super::text::{Text, braced};
use crate::ScalarType;
use crate::emit::Subject;
use crate::emit::documentation::plain;
use crate::emit::markers::{constant_names, loads};

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
    let [names, stress_names, section_names] = constant_names(model, &RESERVED);
    let constants = model.section_markers.iter().zip(&section_names);
    declare(
        text,
        style,
        (
            "section_marker",
            "A cut: rows of force x, y, z and moment x, y, z, to be multiplied by q. Units: m; N and N m per unit modal coordinate.",
        ),
        &[("force", 6)],
        constants.map(|(marker, name)| (format!("Section `{}`.", plain(&marker.name)), name)),
    );
    let constants = model.stress_markers.iter().zip(&stress_names);
    declare(
        text,
        style,
        (
            "stress_marker",
            "A stress marker: rows xx, yy, zz, xy, xz, yz, to be multiplied by q. Units: m; N/m² per unit modal coordinate.",
        ),
        &[("stress", 6)],
        constants.map(|(marker, name)| (format!("Stress marker `{}`.", plain(&marker.name)), name)),
    );
    let constants = model.markers.iter().zip(&names);
    declare(
        text,
        style,
        ("marker", "A marker. Units: m, and per unit modal coordinate; a row for each axis. Frame: body."),
        &[("translation", 3), ("rotation", 3)],
        constants.map(|(marker, name)| (format!("Marker `{}`.", plain(&marker.name)), name)),
    );
    let all = [names, stress_names, section_names];
    for (number, load) in loads(model, &subject.options.fidelity) {
        let Some(name) = stressed(&all, number, style) else { continue };
        text.documentation([
            format!("Loads at `{}` stress the body: its rows in a deformation are", plain(&load.marker)),
            "translation[k][m] - sum over n of STRESSED[k][m][n] q[n], and of the rotation with STRESSED[3 + k]; its place"
                .to_owned(),
            "is the mean of what these and the rows of the undeformed body give.".to_owned(),
        ]);
        text.line(format!("extern const {name};"));
        text.blank();
    }
}

/// The stress stiffness of the marker of this number, declared: under a name that none of all markers has.
fn stressed(all: &[Vec<String>; 3], number: u16, style: &Style) -> Option<String> {
    let [names, ..] = all;
    let mut name = format!("{}_STRESSED", names.get(usize::from(number))?);
    while all.iter().flatten().any(|taken| *taken == name) {
        name.push('_');
    }
    let (scalar, prefix, modes) = (style.type_name(), &style.macro_prefix, style.mode_count);
    Some(format!("{scalar} {prefix}_{name}[6][{modes}][{modes}]"))
}

/// Writes the numbers of the markers.
pub(super) fn definitions(text: &mut Text, subject: &Subject<'_>, style: &Style) {
    let Some(model) = subject.model else { return };
    let all = constant_names(model, &RESERVED);
    for (number, load) in loads(model, &subject.options.fidelity) {
        let Some(name) = stressed(&all, number, style) else { continue };
        text.block(&format!("const {name} = {{"), "};\n", |text| {
            for axis in 0..6 {
                let rows = load.stiffness.iter().map(|row| list(row.iter().map(|load| load[axis]), style));
                let comma = if axis < 5 { "," } else { "" };
                text.line(format!("{}{comma}", braced(&rows.collect::<Vec<_>>())));
            }
        });
    }
    let [names, stress_names, section_names] = all;
    for (marker, name) in model.markers.iter().zip(names) {
        let head = format!("const {}_marker {}_{name} = {{", style.prefix, style.macro_prefix);
        text.block(&head, "};\n", |text| numbers(text, marker, style));
    }
    for (marker, name) in model.stress_markers.iter().zip(stress_names) {
        let head = format!("const {}_stress_marker {}_{name} = {{", style.prefix, style.macro_prefix);
        text.block(&head, "};\n", |text| one_list(text, &marker.position, &marker.stress, style));
    }
    for (marker, name) in model.section_markers.iter().zip(section_names) {
        let head = format!("const {}_section_marker {}_{name} = {{", style.prefix, style.macro_prefix);
        text.block(&head, "};\n", |text| one_list(text, &marker.position, &marker.force, style));
    }
}

/// Writes a type of markers and what there is of it. `kind`: its name and what it is; `fields`: names and rows of shapes;
/// `constants`: what each is and its name.
fn declare<'a>(
    text: &mut Text,
    style: &Style,
    (kind, about): (&str, &str),
    fields: &[(&str, usize)],
    constants: impl Iterator<Item = (String, &'a String)>,
) {
    let mut constants = constants.peekable();
    if constants.peek().is_none() {
        return;
    }
    let (prefix, scalar, modes) = (&style.prefix, style.type_name(), style.mode_count);
    text.documentation([about.to_owned()]);
    text.block("typedef struct {", &format!("}} {prefix}_{kind};\n"), |text| {
        text.line(format!("{scalar} position[3];"));
        if modes > 0 {
            for (field, rows) in fields {
                text.line(format!("{scalar} {field}[{rows}][{modes}];"));
            }
        }
    });
    for (documentation, name) in constants {
        text.documentation([documentation]);
        text.line(format!("extern const {prefix}_{kind} {}_{name};", style.macro_prefix));
    }
    text.blank();
}

fn one_list(text: &mut Text, place: &[f64; 3], list: &[[f64; 6]], style: &Style) {
    position(text, place, style);
    if style.mode_count > 0 {
        rows(text, list, "}", style);
    }
}

fn numbers(text: &mut Text, marker: &Marker, style: &Style) {
    position(text, &marker.position, style);
    if style.mode_count > 0 {
        rows(text, &marker.translation, "},", style);
        rows(text, &marker.rotation, "}", style);
    }
}

/// The position, with a comma if shapes follow.
fn position(text: &mut Text, position: &[f64; 3], style: &Style) {
    let comma = if style.mode_count == 0 { "" } else { "," };
    text.line(format!("{}{comma}", list(position.iter().copied(), style)));
}

/// One row for each component of the shapes of all modes.
fn rows<const N: usize>(text: &mut Text, shapes: &[[f64; N]], end: &str, style: &Style) {
    text.block("{", end, |text| {
        for component in 0..N {
            let comma = if component + 1 < N { "," } else { "" };
            text.line(format!("{}{comma}", list(shapes.iter().map(|shape| shape[component]), style)));
        }
    });
}

fn list(values: impl Iterator<Item = f64>, style: &Style) -> String {
    braced(&values.map(|value| number(value, style.scalar)).collect::<Vec<_>>())
}
