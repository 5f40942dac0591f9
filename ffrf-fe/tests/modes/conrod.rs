//! Many modes of the connecting rod against LAPACK's dense solution of the same matrices.

use std::fs;
use std::path::{Path, PathBuf};

use ffrf_fe::FeModel;
use ffrf_fe::import::{ModelFiles, NodeSource, read_model};
use ffrf_fe::modes::{ModeRequest, compute_modes};

use crate::tolerances::{LAPACK, ORTHOGONALITY, RESIDUAL};

fn package() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}

fn rod() -> FeModel {
    let deck = package().join("../models/conrod/conrod.inp");
    read_model(&ModelFiles { nodes: NodeSource::Calculix(deck), mass: None, stiffness: None }).unwrap()
}

/// The table of `data/conrod_frequencies.py`: 200 frequencies of the free rod, then 200 with the big end held.
fn expected(clamped: bool) -> Vec<f64> {
    let text = fs::read_to_string(package().join("tests/modes/data/conrod_frequencies.txt")).unwrap();
    let values: Vec<f64> =
        text.lines().filter(|line| !line.starts_with('#')).map(|line| line.parse().unwrap()).collect();
    assert_eq!(values.len(), 400);
    values[if clamped { 200..400 } else { 0..200 }].to_vec()
}

fn check(model: &FeModel, request: &ModeRequest, expected: &[f64]) {
    let report = compute_modes(model, request, &mut |_| {}).unwrap().report;
    assert!(report.method.contains("Lanczos"), "{}", report.method);
    assert_eq!(report.counted, Some(report.found));
    assert!(report.orthogonality_error < ORTHOGONALITY, "{:e}", report.orthogonality_error);
    assert_eq!(report.modes.len(), request.count);
    for (mode, expected) in report.modes.iter().zip(expected) {
        let (found, residual) = (mode.frequency_hz.unwrap(), mode.residual.unwrap());
        assert!(residual < RESIDUAL, "mode {}: residual {residual:e}", mode.number);
        assert!((found / expected - 1.0).abs() < LAPACK, "mode {}: {found} Hz, {expected} Hz", mode.number);
    }
}

#[test]
fn many_modes_of_the_free_rod() {
    let (model, expected) = (rod(), expected(false));
    for count in [48, 200] {
        check(&model, &ModeRequest::free_free(count), &expected);
    }
}

#[test]
fn many_modes_of_the_clamped_rod() {
    let (model, expected) = (rod(), expected(true));
    for count in [64, 100] {
        check(&model, &ModeRequest::clamped(count, model.nodes.sets["BIG_END"].clone()), &expected);
    }
}
