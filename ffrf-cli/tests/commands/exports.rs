//! Real exports by way of the command: eigenmodes, a reduced body, and its check by brute force.
//!
//! Needs `../shared` beside the workspace; says so and passes where that is missing.
#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};

use crate::workbench::Workbench;
use serde_json::Value;

/// Relative error of eigenfrequencies against those of the reference.
const FREQUENCY_TOLERANCE: f64 = 1e-6;

fn shared() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared");
    if folder.join("fe-exports").is_dir() {
        return Some(folder);
    }
    eprintln!("SKIPPED: {}/fe-exports is missing; no export was checked", folder.display());
    None
}

/// Reduces to eight modes, verifies, and hands back the frequencies.
fn frequencies(files: &[(&str, PathBuf)]) -> Vec<f64> {
    let bench = Workbench::new();
    let mut words: Vec<&str> = Vec::new();
    for (option, path) in files {
        words.extend([*option, path.to_str().unwrap()]);
    }
    words.extend(["--modes", "8"]);
    bench.run_words([&["reduce"], &words[..], &["-o", "body.ffrf.json"]].concat()).succeeded();
    let said = bench.run_words([&["verify"], &words[..], &["body.ffrf.json"]].concat()).succeeded();
    assert!(said.contains("verified"), "{said}");
    let body: Value = serde_json::from_str(&bench.read("body.ffrf.json")).unwrap();
    body["modes"].as_array().unwrap().iter().map(|mode| mode["frequency_hz"].as_f64().unwrap()).collect()
}

#[test]
fn abaqus_bodies_have_the_frequencies_of_the_reference() {
    let Some(folder) = shared() else { return };
    let bodies = [
        ("blockC3D8", "blockC3D8.inp", "blockC3D8_MASS1.mtx", "blockC3D8_STIF1.mtx"),
        ("blockC3D10", "blockC3D10.inp", "blockC3D10_MASS1.mtx", "blockC3D10_STIF1.mtx"),
        ("rotorDisc", "rotorDiscTest.inp", "rotorDiscTestMASS1.mtx", "rotorDiscTestSTIF1.mtx"),
    ];
    for (name, deck, mass, stiffness) in bodies {
        let file = |file: &str| folder.join("fe-exports").join(file);
        let found = frequencies(&[
            ("--abaqus", file(deck)),
            ("--mass", file(mass)),
            ("--stiffness", file(stiffness)),
        ]);
        let case = std::fs::read_to_string(folder.join("reference").join(format!("{name}.json"))).unwrap();
        let case: Value = serde_json::from_str(&case).unwrap();
        let expected = case["frequencies_hz"].as_array().unwrap();
        assert!(!expected.is_empty());
        for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
            let expected = expected.as_f64().unwrap();
            let error = (found / expected - 1.0).abs();
            assert!(
                error <= FREQUENCY_TOLERANCE,
                "{name}, mode {index}: {found} Hz instead of {expected} Hz"
            );
        }
    }
}

#[test]
fn an_ansys_export_goes_all_the_way() {
    let Some(folder) = shared() else { return };
    let file = |file: &str| folder.join("fe-exports").join(file);
    let found = frequencies(&[
        ("--ansys", file("rotorAnsysNodalCoordinates.txt")),
        ("--mapping", file("rotorAnsysMatrixDofMappingVector.txt")),
        ("--mass", file("rotorAnsysMassMatrixSparse.txt")),
        ("--stiffness", file("rotorAnsysStiffnessMatrixSparse.txt")),
    ]);
    // A rotor with a disc bends alike in both directions across its axis.
    assert!((found[1] / found[0] - 1.0).abs() < FREQUENCY_TOLERANCE, "{found:?}");
}
