//! Slender beams against Euler-Bernoulli theory, and supports that leave rigid motion.

use std::f64::consts::TAU;

use ffrf_fe::elements::{Material, brick};
use ffrf_fe::modes::{ModeRequest, compute_modes};

use crate::tolerances::SLENDER_BEAM;

/// Bending frequency of a beam of square section `side`: (κ²/2π) sqrt(E I / ρ A) / L², with κL from theory.
fn beam_frequency(kappa_length: f64, length: f64, side: f64, material: &Material) -> f64 {
    let radius_of_gyration = side / 12.0_f64.sqrt();
    let speed = (material.youngs_modulus / material.density).sqrt();
    kappa_length.powi(2) / TAU * radius_of_gyration * speed / length.powi(2)
}

/// Without Poisson's effect trilinear elements bend less stiffly, and the theory has none.
const MATERIAL: Material = Material { poisson_ratio: 0.0, ..Material::STEEL };
const LENGTH: f64 = 1.0;
const SIDE: f64 = 0.02;

#[test]
fn free_beam_bends_at_the_frequency_of_the_textbook() {
    let model = brick([LENGTH, SIDE, SIDE], [200, 2, 2], &MATERIAL).unwrap();
    let solution = compute_modes(&model, &ModeRequest::free_free(4), &mut |_| {}).unwrap();
    println!("{}", solution.report);
    // cos κL cosh κL = 1
    for (pair, kappa_length) in [4.730_040_745, 7.853_204_624].into_iter().enumerate() {
        let expected = beam_frequency(kappa_length, LENGTH, SIDE, &MATERIAL);
        for mode in [2 * pair, 2 * pair + 1] {
            let found = solution.report.modes[mode].frequency_hz.unwrap();
            assert!((found / expected - 1.0).abs() < SLENDER_BEAM, "{found} Hz, theory {expected} Hz");
        }
    }
}

#[test]
fn clamped_beam_bends_at_the_frequency_of_the_textbook() {
    let model = brick([LENGTH, SIDE, SIDE], [200, 2, 2], &MATERIAL).unwrap();
    let root = (0..model.nodes.len()).filter(|&node| model.nodes.positions[node][0] == 0.0).collect();
    let solution = compute_modes(&model, &ModeRequest::clamped(2, root), &mut |_| {}).unwrap();
    println!("{}", solution.report);
    // cos κL cosh κL = -1; effective mass of the first bending mode: 61.3 % (Blevins 1979, table 8-1).
    let expected = beam_frequency(1.875_104_069, LENGTH, SIDE, &MATERIAL);
    let mut along_y_and_z = 0.0;
    for mode in &solution.report.modes {
        let found = mode.frequency_hz.unwrap();
        assert!((found / expected - 1.0).abs() < SLENDER_BEAM, "{found} Hz, theory {expected} Hz");
        along_y_and_z += mode.effective_mass[1] + mode.effective_mass[2];
    }
    let part = along_y_and_z / 2.0 / solution.report.total_mass;
    assert!((part - 0.613).abs() < 0.01, "effective mass of the first pair {part}");
}

#[test]
fn supports_at_points_leave_rotations_that_are_removed() {
    let model = brick([0.3, 0.1, 0.1], [6, 2, 2], &MATERIAL).unwrap();
    let at = |x: f64, y: f64| {
        model
            .nodes
            .positions
            .iter()
            .position(|p| (p[0] - x).abs() < 1e-9 && (p[1] - y).abs() < 1e-9 && p[2] == 0.0)
            .unwrap()
    };
    for (clamp, rigid) in [(vec![at(0.0, 0.0)], 3), (vec![at(0.0, 0.0), at(0.3, 0.0)], 1)] {
        let solution = compute_modes(&model, &ModeRequest::clamped(2, clamp), &mut |_| {}).unwrap();
        assert_eq!(solution.report.rigid_modes.len(), rigid);
        assert!(solution.report.modes[0].frequency_hz.unwrap() > 1.0);
        assert_eq!(solution.report.counted, Some(solution.report.found));
    }
}

#[test]
fn boundary_conditions_of_the_export_hold() {
    let mut model = brick([0.3, 0.1, 0.1], [6, 2, 2], &MATERIAL).unwrap();
    let root: Vec<usize> =
        (0..model.nodes.len()).filter(|&node| model.nodes.positions[node][0] == 0.0).collect();
    let clamped = compute_modes(&model, &ModeRequest::clamped(3, root.clone()), &mut |_| {}).unwrap();
    model.fixed_dofs = root.iter().flat_map(|&node| 3 * node..3 * node + 3).collect();
    let held = compute_modes(&model, &ModeRequest::free_free(3), &mut |_| {}).unwrap();
    for (a, b) in clamped.report.modes.iter().zip(&held.report.modes) {
        assert_eq!(a.frequency_hz, b.frequency_hz);
    }
}
