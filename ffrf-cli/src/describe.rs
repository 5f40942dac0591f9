//! A reduced body in words and numbers.

use std::fmt::Write;

use ffrf_model::{CheckReport, ModeKind, ReducedBody};

/// Title, inertia, provenance, markers.
pub fn body(body: &ReducedBody) -> String {
    let mut text = String::new();
    let inertia = &body.inertia;
    let tensor = inertia.inertia_tensor();
    let [ax, ay, az] = inertia.centre_of_mass();
    line(&mut text, "title", &body.title);
    line(&mut text, "units", &body.units);
    line(&mut text, "mass", &format!("{}", Number(inertia.mass)));
    line(&mut text, "centre of mass", &format!("{} {} {}", Number(ax), Number(ay), Number(az)));
    for (label, row) in ["inertia about origin", "", ""].into_iter().zip(tensor) {
        line(&mut text, label, &format!("{} {} {}", Number(row[0]), Number(row[1]), Number(row[2])));
    }
    line(&mut text, "modes", &body.mode_count().to_string());
    for marker in &body.markers {
        let [x, y, z] = marker.position;
        let nodes = match marker.nodes.as_slice() {
            [node] => format!("node {node}"),
            nodes => format!("{} nodes", nodes.len()),
        };
        let place = format!("{} ({nodes}) at {} {} {}", marker.name, Number(x), Number(y), Number(z));
        line(&mut text, "marker", &place);
    }
    for source in &body.provenance.sources {
        let hash = source.sha256.get(..12).unwrap_or(&source.sha256);
        line(&mut text, "source", &format!("{}: {} (sha256 {hash})", source.role, source.file));
    }
    text
}

/// Kind, frequency, modal mass, stiffness and damping of each mode.
pub fn mode_table(body: &ReducedBody) -> String {
    let mut text = String::from("mode  kind       frequency [Hz]   modal mass     stiffness      damping\n");
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
            "{:>4}  {kind:<9}  {frequency:>14}   {:<13} {:<13} {}",
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
