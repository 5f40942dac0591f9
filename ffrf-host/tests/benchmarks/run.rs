//! Scenes of `models/scenes` and of tests, run to their end.

use std::path::{Path, PathBuf};

use ffrf_host::scene::Scene;
use ffrf_host::simulate::{Sample, Summary, header, simulate};
use nalgebra::Vector3;

/// What a run has shown.
pub struct Run {
    names: Vec<String>,
    pub samples: Vec<Sample>,
    pub summary: Summary,
}

/// The text of a scene of `models/scenes`.
pub fn scene_text(name: &str) -> String {
    let path = scenes().join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes")
}

/// A scene of `models/scenes` with some texts replaced by others.
pub fn run_scene(name: &str, replacements: &[(&str, &str)]) -> Run {
    let mut text = scene_text(name);
    for (from, to) in replacements {
        assert!(text.contains(from), "{name} has no `{from}`");
        text = text.replace(from, to);
    }
    run_text(&text, &scenes())
}

/// A scene from its text, with the files that it names in `folder`.
pub fn run_text(text: &str, folder: &Path) -> Run {
    let scene = compose(text, folder);
    let mut samples = Vec::new();
    let keep = |sample: &Sample| {
        samples.push(sample.clone());
        Ok(())
    };
    let summary = simulate(&scene, None, keep, |_| ()).unwrap_or_else(|error| panic!("{error}"));
    Run { names: header(&scene), samples, summary }
}

/// The scene of a text.
pub fn compose(text: &str, folder: &Path) -> Scene {
    let file = ffrf_host::scene::file::SceneFile::parse(text).unwrap_or_else(|error| panic!("{error}"));
    Scene::compose(&file, folder).unwrap_or_else(|error| panic!("{error}"))
}

impl Run {
    fn place(&self, column: &str) -> usize {
        let place = self.names.iter().position(|name| name == column);
        place.unwrap_or_else(|| panic!("no column {column}")) - 1
    }

    /// A column at every sample.
    pub fn column(&self, name: &str) -> Vec<f64> {
        let place = self.place(name);
        self.samples.iter().map(|sample| sample.values[place]).collect()
    }

    /// A column at the end.
    pub fn last(&self, name: &str) -> f64 {
        self.samples.last().unwrap().values[self.place(name)]
    }

    /// Three columns at the end.
    pub fn last_vector(&self, name: &str) -> Vector3<f64> {
        Vector3::new(
            self.last(&format!("{name}.x")),
            self.last(&format!("{name}.y")),
            self.last(&format!("{name}.z")),
        )
    }

    /// The largest change of the total energy. Units: J.
    pub fn energy_error(&self) -> f64 {
        let parts = ["energy.kinetic", "energy.elastic", "energy.potential"].map(|name| self.column(name));
        let total = |k: usize| parts.iter().map(|part| part[k]).sum::<f64>();
        (0..self.samples.len()).map(|k| (total(k) - total(0)).abs()).fold(0.0, f64::max)
    }

    /// The largest residual of the joints at any sample: positions (m or rad), velocities.
    pub fn drift(&self) -> [f64; 2] {
        ["drift.position", "drift.velocity"].map(|name| self.column(name).into_iter().fold(0.0, f64::max))
    }
}

/// Fails unless a number is as expected.
#[track_caller]
pub fn near(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    eprintln!("{what}: {found:.12e}, published {expected:.12e}, off by {error:.1e}");
    assert!(error <= tolerance, "{what}: {found} and {expected}, off by {error:e}, allowed {tolerance:e}");
}
