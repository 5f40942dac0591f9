//! Scenes of the project as tests want them.

use std::path::Path;

/// A scene with another step and integrator.
pub fn with_step(path: &Path, integrator: &str, step: f64) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter(|line| {
        !["step", "integrator", "tolerance"].iter().any(|key| line.starts_with(&format!("{key} =")))
    });
    let text: String = lines.map(|line| format!("{line}\n")).collect();
    let head = format!("[simulation]\nstep = {step:?}\nintegrator = \"{integrator}\"\n");
    text.replacen("[simulation]\n", &head, 1)
}
