//! Misuse of `flexible_body!` is answered with one message per mistake, at its place.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use ffrf_model::ReducedBody;

/// Messages belong to one compiler; others may word or place them differently.
const PINNED: &str = "1.95.0";

#[test]
fn each_mistake_has_its_message() {
    let version = std::process::Command::new("rustc").arg("--version").output();
    let version =
        version.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    if !version.contains(PINNED) {
        eprintln!("SKIPPED: messages are those of rustc {PINNED}, found {version}");
        return;
    }
    write_models();
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}

/// The models that the cases name, next to the manifest that trybuild compiles them with.
fn write_models() {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().unwrap();
    let folder = target.join("tests/trybuild/ffrf/models");
    std::fs::create_dir_all(&folder).unwrap();
    let sound = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models/random_m4.ffrf.json");
    let sound = ReducedBody::read(sound).unwrap();
    sound.write(folder.join("sound.ffrf.json")).unwrap();
    let mut faulty = sound.clone();
    faulty.stiffness[0][2] += 0.5 * faulty.stiffness[0][0];
    faulty.write(folder.join("asymmetric.ffrf.json")).unwrap();
    let mut faulty = sound;
    faulty.damping[1][1] = -faulty.damping[1][1] - 1.0;
    faulty.write(folder.join("negative_damping.ffrf.json")).unwrap();
}
