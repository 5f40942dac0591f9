//! Running the command on scenes of the repository.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Runs the command.
pub fn ffrf(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ffrf")).args(arguments).output().unwrap()
}

/// The path of a scene of `models/scenes`.
pub fn scene(name: &str) -> String {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(name).display().to_string()
}

/// A scene of `models/scenes` in `folder`, with a part of its text replaced.
pub fn changed(folder: &Path, name: &str, replacements: &[(&str, &str)]) -> String {
    let mut text = std::fs::read_to_string(scene(name)).unwrap();
    text = text.replace("\"../conrod", &format!("\"{}", scene("../conrod")));
    for (from, to) in replacements {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    let path = folder.join(
        format!("{}-{name}", replacements.last().map_or("", |(_, to)| to.trim()))
            .replace(['"', ' ', '='], ""),
    );
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// Runs the command and asserts success.
#[track_caller]
pub fn succeed(arguments: &[&str]) -> Output {
    let run = ffrf(arguments);
    assert!(run.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&run.stderr));
    run
}
