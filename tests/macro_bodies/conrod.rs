//! The connecting rod in `models/`: our modes against CalculiX, the committed model against a fresh reduction.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use std::fs;
use std::path::{Path, PathBuf};

use ffrf_fe::FeModel;
use ffrf_fe::import::{ModelFiles, NodeSource, read_model};
use ffrf_fe::modes::{ModeRequest, ModeSolution, compute_modes};
use ffrf_fe::reduction::{MarkerRequest, ReductionOptions, reduce};
use ffrf_model::ReducedBody;

/// CalculiX prints seven digits of an eigenvalue, ω², of which the last may be off by one.
const PRINTED_DIGITS: f64 = 1e-6;
/// Modes are the end of an iteration in floating point; another machine rounds differently.
const SAME_MODES: f64 = 1e-9;
/// What the repository may carry, in bytes.
const LARGEST_FOLDER: u64 = 4_000_000;

fn models() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("models")
}

fn model_and_modes(count: usize) -> (FeModel, ModeSolution) {
    let deck = models().join("conrod/conrod.inp");
    let files = ModelFiles { nodes: NodeSource::Calculix(deck), mass: None, stiffness: None };
    let model = read_model(&files).unwrap();
    let solution = compute_modes(&model, &ModeRequest::free_free(count), &mut |_| ()).unwrap();
    (model, solution)
}

/// Eigenvalues ω² in the table that CalculiX printed: lines with a number and four reals.
fn printed_eigenvalues() -> Vec<f64> {
    let text = fs::read_to_string(models().join("conrod/conrod_frequencies.txt")).unwrap();
    text.lines()
        .filter_map(|line| {
            let fields: Vec<&str> = line.split_whitespace().collect();
            (fields.len() == 5 && fields[0].parse::<usize>().is_ok()).then(|| fields[1].parse().unwrap())
        })
        .collect()
}

#[test]
fn frequencies_are_those_that_calculix_finds() {
    let printed = printed_eigenvalues();
    assert_eq!(printed.len(), 20, "six rigid-body modes and fourteen elastic ones");
    let (_, solution) = model_and_modes(14);
    assert_eq!(solution.report.rigid_modes.len(), 6);
    for (mode, expected) in solution.basis.modes.iter().zip(&printed[6..]) {
        let found = (std::f64::consts::TAU * mode.frequency_hz.unwrap()).powi(2);
        assert!((found / expected - 1.0).abs() < PRINTED_DIGITS, "ω² {found:e}, CalculiX {expected:e}");
    }
}

#[test]
fn the_committed_model_is_what_the_export_reduces_to() {
    let committed = ReducedBody::read(models().join("conrod.ffrf.json")).unwrap();
    let (model, solution) = model_and_modes(committed.mode_count());
    let markers = ["BIG_END", "SMALL_END"];
    let request = |name: &str| MarkerRequest {
        name: name.to_owned(),
        nodes: model.nodes.sets.get(name).unwrap().clone(),
    };
    let options = ReductionOptions {
        title: committed.title.clone(),
        markers: markers.map(request).to_vec(),
        ..ReductionOptions::default()
    };
    let fresh = reduce(&model, &solution.basis, &options).unwrap();
    assert_eq!(fresh.provenance, committed.provenance, "made from the files that are there");
    for (new, old) in fresh.modes.iter().zip(&committed.modes) {
        let (new, old) = (new.frequency_hz.unwrap(), old.frequency_hz.unwrap());
        assert!((new / old - 1.0).abs() < SAME_MODES, "{new} Hz, committed {old} Hz");
    }
    for (new, old) in fresh.markers.iter().zip(&committed.markers) {
        assert_eq!((&new.name, &new.nodes), (&old.name, &old.nodes));
        let largest = old.translation.as_flattened().iter().fold(0.0_f64, |max, x| max.max(x.abs()));
        for (new, old) in new.translation.as_flattened().iter().zip(old.translation.as_flattened()) {
            assert!(
                (new - old).abs() < SAME_MODES * largest,
                "mode shape at a marker: {new}, committed {old}"
            );
        }
    }
}

#[test]
fn the_export_stays_small() {
    let sizes =
        fs::read_dir(models().join("conrod")).unwrap().map(|entry| entry.unwrap().metadata().unwrap().len());
    let total: u64 = sizes.sum();
    assert!(total < LARGEST_FOLDER, "models/conrod holds {total} bytes, at most {LARGEST_FOLDER}");
}
