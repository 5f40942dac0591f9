//! Units of a real part: conversion leaves the physics alone, and wrong units are remarked upon.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use ffrf_fe::import::{ModelFiles, NodeSource, read_model};
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_fe::reduction::{ReductionOptions, reduce};
use ffrf_fe::units::{Conversion, implausible};
use ffrf_fe::{FeError, FeModel};
use ffrf_model::{SourceFile, Units};

/// The connecting rod, in SI units.
fn conrod() -> FeModel {
    let deck = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/conrod/conrod.inp"));
    read_model(&ModelFiles { nodes: NodeSource::Calculix(deck.to_path_buf()), mass: None, stiffness: None })
        .unwrap()
}

fn units(text: &str) -> Units {
    text.parse().unwrap()
}

fn first_frequency(model: &FeModel) -> f64 {
    let solution = compute_modes(model, &ModeRequest::free_free(1), &mut |_| {}).unwrap();
    solution.report.modes[0].frequency_hz.unwrap()
}

#[test]
fn a_part_converted_there_and_back_is_the_same_part() {
    let si = conrod();
    let frequency = first_frequency(&si);
    for other in ["mm,t,s", "mm,kg,ms", "in,slinch,s"].map(units) {
        let mut model = si.clone();
        Conversion::new(&Units::SI, &other).model(&mut model);
        assert!(
            (model.nodes.positions[0][0] * other.length() / si.nodes.positions[0][0] - 1.0).abs() < 1e-14
        );
        // Two solves in different scales agree to the residual of the modes.
        assert!((first_frequency(&model) / other.time() / frequency - 1.0).abs() < 1e-8, "{other}");
        assert_eq!(implausible(&model, Some(other), Some(frequency * other.time())), [""; 0]);
        Conversion::new(&other, &Units::SI).model(&mut model);
        let sum =
            |model: &FeModel| model.stiffness.as_ref().unwrap().val().iter().map(|v| v.abs()).sum::<f64>();
        assert!((sum(&model) / sum(&si) - 1.0).abs() < 1e-14);
    }
}

#[test]
fn numbers_that_no_solid_has_are_remarked_upon() {
    let si = conrod();
    let frequency = first_frequency(&si);
    assert_eq!(implausible(&si, None, Some(frequency)), [""; 0]);
    let mut millimetres = si.clone();
    Conversion::new(&Units::SI, &units("mm,t,s")).model(&mut millimetres);
    let remarks = implausible(&millimetres, None, Some(frequency)).join("\n");
    for part in
        ["density is 7.", "e-9 kg/m^3", "not stated", "in mm, t, s, N all these figures would be ordinary"]
    {
        assert!(remarks.contains(part), "`{remarks}` lacks `{part}`");
    }
    // Mixed: millimetres and MPa with a density in kg/m³.
    let mut mixed = millimetres;
    mixed.mass.val_mut().iter_mut().for_each(|value| *value *= 1e12);
    let remarks = implausible(&mixed, Some(Units::SI), Some(frequency * 1e-6)).join("\n");
    for part in ["first frequency is", "one coherent set of units"] {
        assert!(remarks.contains(part), "`{remarks}` lacks `{part}`");
    }
}

#[test]
fn modes_that_repeat_each_other_are_blamed_on_their_file() {
    let mut model = conrod();
    model.sources.push(SourceFile {
        role: ffrf_fe::reduction::MODE_SHAPES.to_owned(),
        file: "psi.txt".to_owned(),
        sha256: String::new(),
    });
    let found = compute_modes(&model, &ModeRequest::free_free(2), &mut |_| {}).unwrap().basis.shapes;
    let twice = faer::Mat::from_fn(found.nrows(), 3, |i, j| found[(i, j % 2)]);
    let basis = ffrf_fe::modes::user_modes(&model, twice).unwrap().basis;
    let error = reduce(&model, &basis, &ReductionOptions::default()).unwrap_err();
    assert!(matches!(&error, FeError::UserModes { file, .. } if file == "psi.txt"), "{error}");
    assert!(error.to_string().starts_with("psi.txt: the body is not consistent: independence"), "{error}");
}
