//! Bodies, markers, the state at the beginning, and who prepares which body.

use std::fmt::Write as _;

use super::Numbers;
use super::compliance::rigid_compliance;
use super::numbers::table;
use crate::emit::c::mechanism::MechanismSubject;
use crate::emit::c::text::braced;
use crate::mechanism::BodyKind;

/// The bodies and their markers.
pub(super) fn bodies(subject: &MechanismSubject<'_>, numbers: &Numbers) -> String {
    let model = subject.model;
    let (mut rigid, mut flexible, mut which, mut matrices) = (vec![], vec![], vec![], String::new());
    for (body, name) in model.bodies.iter().zip(&subject.names.bodies) {
        match &body.kind {
            BodyKind::Rigid { mass, first_moment, inertia } => {
                let mut parts = vec![numbers.one(*mass), numbers.list(first_moment), numbers.list(inertia)];
                if subject.has_loops {
                    parts.push(numbers.list(&rigid_compliance(*mass, first_moment, inertia)));
                }
                rigid.push(format!("{{{}}}", parts.join(", ")));
                which.push(format!("-{}", rigid.len()));
            }
            BodyKind::Flexible(body) => {
                let mut entry = format!("{{{}, {}", body.model.mode_count(), u8::from(body.is_diagonal));
                for (what, values) in [
                    ("modal_mass", &body.modal_mass),
                    ("stiffness", &body.stiffness),
                    ("damping", &body.damping),
                ] {
                    let _ = writeln!(
                        matrices,
                        "static const real {name}_{what}[{}] = {};\n",
                        values.len(),
                        numbers.list(values)
                    );
                    let _ = write!(entry, ", {name}_{what}");
                }
                which.push(flexible.len().to_string());
                flexible.push(entry + "}");
            }
        }
    }
    let mut text = matrices;
    text.push_str(&table("rigid_body", "rigid_bodies", &rigid));
    text.push_str(&table("flexible_body", "flexible_bodies", &flexible));
    if !flexible.is_empty() {
        text.push_str("/* Which flexible body a body is; below zero for rigid ones. */\n");
        text.push_str(&format!("static const int flexible_of[BODIES] = {};\n\n", braced(&which)));
    }
    let (mut markers, mut shapes) = (vec![], vec![]);
    for marker in &model.markers {
        let modes = model.bodies.get(marker.body).map_or(0, |body| body.kind.mode_count());
        let shape = if modes > 0 { shapes.len().to_string() } else { "-1".to_owned() };
        markers.push(format!("{{{}, {}, {shape}}}", marker.body, numbers.list(&marker.position)));
        if modes > 0 {
            let rows = |rows: &[Vec<f64>; 3]| {
                let filled = rows.iter().flat_map(|row| {
                    row.iter()
                        .copied()
                        .chain(std::iter::repeat_n(0.0, subject.modes().saturating_sub(row.len())))
                });
                numbers.list(&filled.collect::<Vec<f64>>())
            };
            let mut shape = vec![rows(&marker.translation), rows(&marker.rotation)];
            if let Some(load) = &marker.load_stiffness {
                let (name, entries) = (format!("stressed_{}", shapes.len()), load.concat());
                let (count, list) = (entries.len(), numbers.list(&entries));
                let _ = writeln!(text, "static const real {name}[{count}] = {list};\n");
                shape.push(name);
            } else if model.has_loaded_markers() {
                shape.push("NULL".to_owned());
            }
            shapes.push(format!("{{{}}}", shape.join(", ")));
        }
    }
    if markers.is_empty() {
        markers.push(format!("{{0, {}, -1}}", numbers.list(&[0.0; 3])));
    }
    text.push_str(&table("marker_place", "markers", &markers));
    text.push_str(&table("marker_shape", "shapes", &shapes));
    text
}

/// The state at the beginning.
pub(super) fn beginning(subject: &MechanismSubject<'_>, numbers: &Numbers) -> String {
    let modes = subject.modes();
    let padded = |values: &[f64]| {
        let zeros = std::iter::repeat_n(0.0, modes.saturating_sub(values.len()));
        numbers.list(&values.iter().copied().chain(zeros).collect::<Vec<f64>>())
    };
    let bodies = subject.model.bodies.iter().map(|body| {
        let mut parts = vec![numbers.list(&body.position), numbers.list(&body.orientation)];
        if modes > 0 {
            parts.push(padded(&body.modal_coordinates));
        }
        parts.extend([numbers.list(&body.velocity), numbers.list(&body.angular_velocity)]);
        if modes > 0 {
            parts.push(padded(&body.modal_rates));
        }
        format!("    {{{}}}", parts.join(", "))
    });
    let bodies: Vec<String> = bodies.collect();
    format!(
        "static const mechanism_state beginning = {{{{\n{}}},\n    {}\n}};\n\n",
        bodies.join(",\n"),
        numbers.one(0.0)
    )
}

/// The function that gives what depends on the state of each body.
pub(in super::super) fn prepare(subject: &MechanismSubject<'_>) -> String {
    let mut text = String::from(
        "/* What depends on the state of a body. */\n\
         static void prepare_body(int index, const body_state *state, body_work *body)\n{\n    switch (index) {\n",
    );
    let mut rigid = 0;
    for (index, (body, kernel)) in subject.model.bodies.iter().zip(subject.kernel_of).enumerate() {
        let _ = writeln!(text, "    case {index}:");
        match body.kind.mode_count() {
            0 => {
                let _ = writeln!(text, "        prepare_rigid({rigid}, state, body);\n        break;");
                rigid += 1;
            }
            modes => {
                let _ = writeln!(
                    text,
                    "    {{\n        real moment[{0}];\n        real rotation[{0}];\n        \
                     {kernel}_prepare(\n            state->q, state->omega, state->q_dot, &body->mass, \
                     body->first_moment, body->inertia, moment, rotation,\n            \
                     body->quadratic_velocity, body->internal_force\n        );\n        \
                     take_coupling({modes}, moment, rotation, body);\n        break;\n    }}",
                    3 * modes
                );
            }
        }
    }
    text.push_str("    default:\n        break;\n    }\n}\n\n");
    text
}
