//! A reduced body in words and numbers.

use std::f64::consts::TAU;
use std::fmt::Write;

use ffrf_model::{CheckReport, InterfaceCoupling, ModeKind, ReducedBody, Units, printable};

/// Title, inertia, highest frequency and largest stable step, markers, provenance.
pub fn body(body: &ReducedBody) -> String {
    let mut text = String::new();
    let unit = UnitLabels::of(body);
    let inertia = &body.inertia;
    line(&mut text, "title", &printable(&body.title));
    line(&mut text, "units", &unit.summary(body));
    line(&mut text, "mass", &unit.with(&[inertia.mass], "M"));
    line(&mut text, "centre of mass", &unit.with(&inertia.centre_of_mass(), "L"));
    for (label, row) in ["inertia about origin", "", ""].into_iter().zip(inertia.inertia_tensor()) {
        line(&mut text, label, &unit.with(&row, "M L^2"));
    }
    line(&mut text, "modes", &body.mode_count().to_string());
    stability(&mut text, body, &unit);
    for marker in &body.markers {
        let nodes = match marker.nodes.as_slice() {
            [node] => format!("node {node}"),
            nodes => format!("{} nodes", nodes.len()),
        };
        let place = unit.with(&marker.position, "L");
        let (kind, held) = match marker.coupling {
            None => ("marker", nodes),
            Some(InterfaceCoupling::Rigid) => ("interface", format!("{nodes}, as one rigid body: RBE2")),
            Some(InterfaceCoupling::Average) => ("interface", format!("{nodes}, their mean: RBE3")),
        };
        line(&mut text, kind, &format!("{} ({held}) at {place}", printable(&marker.name)));
    }
    for marker in &body.stress_markers {
        let place = unit.with(&marker.position, "L");
        let nodes = marker.nodes.len();
        line(&mut text, "stress marker", &format!("{} ({nodes} nodes) at {place}", printable(&marker.name)));
    }
    for marker in &body.section_markers {
        let place = unit.with(&marker.position, "L");
        let normal = marker.normal.map(|x| format!("{x:.3}")).join(", ");
        let about = format!("{} at {place}, normal ({normal})", printable(&marker.name));
        line(&mut text, "section", &about);
    }
    if let Some(geometric) = &body.geometric_stiffness {
        let names: Vec<String> = geometric.marker_loads.iter().map(|load| printable(&load.marker)).collect();
        let loads =
            if names.is_empty() { String::new() } else { format!(", and of loads at {}", names.join(", ")) };
        line(&mut text, "geometric stiffness", &format!("of inertial loads{loads}"));
    }
    for source in &body.provenance.sources {
        let hash: String = source.sha256.chars().take(12).collect();
        let (role, file, hash) = (printable(&source.role), printable(&source.file), printable(&hash));
        line(&mut text, "source", &format!("{role}: {file} (sha256 {hash})"));
    }
    for note in &body.provenance.notes {
        line(&mut text, "note", &printable(note));
    }
    text
}

/// The highest frequency that the modes retain, and the step that it allows.
fn stability(text: &mut String, body: &ReducedBody, unit: &UnitLabels) {
    let Some(frequency) = body.highest_frequency() else {
        line(text, "highest frequency", "not defined: the masses of the modes are not positive");
        return;
    };
    let free = "of the free body with these modes";
    line(text, "highest frequency", &format!("{} {free}", unit.frequency(frequency / TAU)));
    let step = match body.largest_stable_step() {
        Some(step) if step.is_finite() => unit.with(&[step], "T"),
        _ => "any".to_owned(),
    };
    let method = "for the classical Runge-Kutta method (step_rk4) and small motions; step_linearly_implicit has no limit";
    line(text, "largest stable step", &format!("{step} {method}"));
}

/// Kind, frequency, modal mass, stiffness and damping of each mode.
pub fn mode_table(body: &ReducedBody) -> String {
    let heading = format!("frequency [{}]", if Units::of(&body.units).is_some() { "Hz" } else { "1/time" });
    let mut text = format!("mode  kind       {heading:<18}  modal mass     stiffness      damping\n");
    let modal_mass = body.inertia.modal_mass();
    for (mu, mode) in body.modes.iter().enumerate() {
        let kind = match mode.kind {
            ModeKind::FreeFree => "free-free",
            ModeKind::Clamped => "clamped",
            ModeKind::Component => "component",
            ModeKind::Constraint => "constraint",
            ModeKind::Attachment => "attachment",
            ModeKind::User => "user",
            _ => "other",
        };
        let frequency = mode.frequency_hz.map_or_else(|| "-".to_owned(), |hertz| format!("{hertz:.6}"));
        let _ = writeln!(
            text,
            "{:>4}  {kind:<10} {frequency:>18}  {:<13}  {:<13}  {}",
            mu + 1,
            Number(modal_mass[mu][mu]),
            Number(body.stiffness[mu][mu]),
            Number(body.damping[mu][mu]),
        );
    }
    text
}

/// The checks, one per line, failures marked.
pub fn checks(report: &CheckReport) -> String {
    let mut text = String::from("checks\n");
    for check in &report.checks {
        let verdict = if check.passed() { "ok    " } else { "FAILED" };
        let _ = writeln!(text, "  {verdict}  {check}");
    }
    text
}

fn line(text: &mut String, label: &str, value: &str) {
    let _ = writeln!(text, "{label:<22}{value}");
}

/// The units behind the numbers of a body, if they are known.
struct UnitLabels(Option<Units>);

impl UnitLabels {
    fn of(body: &ReducedBody) -> Self {
        Self(Units::of(&body.units))
    }

    fn summary(&self, body: &ReducedBody) -> String {
        match self.0 {
            Some(_) => printable(&body.units),
            None => format!(
                "{}: numbers are in the units of the files that the body was made from (see --units of `ffrf reduce`)",
                printable(&body.units)
            ),
        }
    }

    /// Numbers and their unit, of a dimension written with M, L and T; without a unit where none is known.
    fn with(&self, numbers: &[f64], dimension: &str) -> String {
        let numbers: Vec<String> = numbers.iter().map(|&number| Number(number).to_string()).collect();
        let unit = self.0.map_or_else(String::new, |units| {
            let (mass, length, time) = (units.mass_name(), units.length_name(), units.time_name());
            dimension.replace('M', mass).replace('L', length).replace('T', time)
        });
        format!("{} {unit}", numbers.join(" ")).trim_end().to_owned()
    }

    /// A frequency, given in cycles per unit of time.
    fn frequency(&self, cycles: f64) -> String {
        match self.0 {
            Some(units) => format!("{} Hz", Number(cycles / units.time())),
            None => format!("{} per unit of time", Number(cycles)),
        }
    }
}

/// A number in six digits, with an exponent where that is shorter to read.
struct Number(f64);

impl std::fmt::Display for Number {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let magnitude = self.0.abs();
        let text = if magnitude == 0.0 || (1e-3..1e6).contains(&magnitude) {
            format!("{:.6}", self.0)
        } else {
            format!("{:.5e}", self.0)
        };
        f.pad(&text)
    }
}
