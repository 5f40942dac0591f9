//! A whole step of the free body: state and classical Runge-Kutta method about the kernels.

use std::collections::BTreeSet;

use super::Style;
use super::notation::{number, square_root_name};
use super::template::filled;
use super::text::Text;

/// The statements, with places for names, sizes and numbers.
const STEP: &str = include_str!("step.c.txt");

/// Writes the type of the state and the prototype of the step.
pub(super) fn declaration(text: &mut Text, style: &Style) {
    let (prefix, kind, modes) = (&style.prefix, style.type_name(), style.mode_count);
    text.documentation([
        "Where the free body is and how it moves. Orientation: Euler parameters, scalar first, body to inertial, of norm one."
            .to_owned(),
        "Units: m, m/s, rad/s, and those of the modes. Frame: inertial; omega: body.".to_owned(),
    ]);
    text.block("typedef struct {", &format!("}} {prefix}_state;\n"), |text| {
        text.line(format!("{kind} position[3];"));
        text.line(format!("{kind} orientation[4];"));
        if modes > 0 {
            text.line(format!("{kind} q[{modes}];"));
        }
        text.line(format!("{kind} velocity[3];"));
        text.line(format!("{kind} omega[3];"));
        if modes > 0 {
            text.line(format!("{kind} q_dot[{modes}];"));
        }
    });
    text.documentation([
        "One step of the classical Runge-Kutta method of order four: the free body under gravity, elastic and damping forces."
            .to_owned(),
        String::new(),
        "Fixed cost: four evaluations of the accelerations. Returns 1, or 0 if the step is not positive and finite, or a number"
            .to_owned(),
        "of the state is not finite before the step or would not be after it; the state is then unchanged.".to_owned(),
        "Shape: gravity 3. Units: gravity m/s², step s. Frame: inertial.".to_owned(),
        "Source: Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, table II.1.2, in the chart of the Cayley"
            .to_owned(),
        "map about the orientation.".to_owned(),
    ]);
    text.line(format!("{};\n", prototype(style)));
}

fn prototype(style: &Style) -> String {
    let (prefix, kind) = (&style.prefix, style.type_name());
    format!("int {prefix}_step_rk4(const {kind} gravity[3], {kind} step, {prefix}_state *state)")
}

/// Writes the functions.
pub(super) fn definition(text: &mut Text, style: &Style) {
    let modes = style.mode_count;
    let features = BTreeSet::from_iter((modes > 0).then_some("MODES"));
    let (q, q_dot) = if modes > 0 { ("state.q, ", "state.q_dot, ") } else { ("", "") };
    let number = |value: f64| number(value, style.scalar);
    let names = [
        ("@QDOT", q_dot.to_owned()),
        ("@Q", q.to_owned()),
        ("@P", style.prefix.clone()),
        ("@HALF", number(0.5)),
        ("@ZERO", number(0.0)),
        ("@ONE", number(1.0)),
        ("@TWO", number(2.0)),
        ("@THREE", number(3.0)),
        ("@SIX", number(6.0)),
        ("@SQRT", square_root_name(style.scalar).to_owned()),
        ("@T", style.type_name().to_owned()),
        ("@N", (12 + 2 * modes).to_string()),
        ("@V", (6 + modes).to_string()),
        ("@M", modes.to_string()),
    ];
    let names = names.each_ref().map(|(place, name)| (*place, name.as_str()));
    for line in filled(STEP, &features, &names).lines() {
        text.line(line);
    }
}
