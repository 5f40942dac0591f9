//! Statics, linearisation and eigenfrequencies of scenes against closed forms, differences, and independent eigenproblems.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod clamped;
mod derivatives;
mod response;
mod rotors;
mod vibrations;

use std::path::{Path, PathBuf};

use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;

/// A scene from its text; models are looked for in `models/scenes`.
fn scene(text: &str) -> Scene {
    let folder: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes");
    Scene::compose(&SceneFile::parse(text).unwrap(), &folder).unwrap()
}

#[track_caller]
fn close(what: &str, found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "{what}: found {found:.15e}, expected {expected:.15e}"
    );
}
