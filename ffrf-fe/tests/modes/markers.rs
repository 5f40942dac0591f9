//! Markers follow rigid motion exactly; damping follows its definition.

use faer::Mat;
use ffrf_fe::elements::{Material, brick};
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_fe::reduction::{Damping, MarkerRequest, ReductionOptions, reduce};
use ffrf_fe::{FeModel, ModeBasis};

use crate::tolerances::MARKER;

fn marker(name: &str, nodes: Vec<usize>) -> MarkerRequest {
    MarkerRequest { name: name.to_owned(), nodes }
}

/// The modes of a small brick, with the small rigid rotation `omega` about the origin added to the first.
fn with_rotation(model: &FeModel, omega: [f64; 3]) -> (ModeBasis, Mat<f64>) {
    let basis = compute_modes(model, &ModeRequest::free_free(2), &mut |_| {}).unwrap().basis;
    let mut turned = basis.shapes.clone();
    for (node, x) in model.nodes.positions.iter().enumerate() {
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            turned[(3 * node + i, 0)] += omega[j] * x[k] - omega[k] * x[j];
        }
    }
    (ModeBasis { shapes: turned, modes: basis.modes.clone() }, basis.shapes)
}

#[test]
fn a_rigid_rotation_is_seen_exactly_by_single_nodes_and_by_sets() {
    let model = brick([0.3, 0.2, 0.1], [3, 2, 2], &Material::STEEL).unwrap();
    let omega = [0.3, -0.2, 0.7];
    let (turned, shapes) = with_rotation(&model, omega);
    let end: Vec<usize> =
        (0..model.nodes.len()).filter(|&node| model.nodes.positions[node][0] == 0.0).collect();
    let options = ReductionOptions {
        markers: vec![marker("corner", vec![0]), marker("end", end.clone())],
        ..ReductionOptions::default()
    };
    let before = reduce(&model, &ModeBasis { shapes, modes: turned.modes.clone() }, &options).unwrap();
    let after = reduce(&model, &turned, &options).unwrap();
    for (before, after) in before.markers.iter().zip(&after.markers) {
        let x = after.position;
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let turn = after.rotation[0][i] - before.rotation[0][i];
            let shift = after.translation[0][i] - before.translation[0][i];
            assert!(
                (turn - omega[i]).abs() < MARKER,
                "{}: rotation {turn}, expected {}",
                after.name,
                omega[i]
            );
            let expected = omega[j] * x[k] - omega[k] * x[j];
            assert!(
                (shift - expected).abs() < MARKER,
                "{}: displacement {shift}, expected {expected}",
                after.name
            );
        }
        assert_eq!(before.rotation[1], after.rotation[1]);
    }
    assert_eq!(after.markers[0].nodes, [1]);
    assert_eq!(after.markers[1].nodes.len(), end.len());
    assert!((after.markers[1].position[1] - 0.1).abs() < 1e-15);
}

#[test]
fn damping_ratios_give_two_zeta_omega_and_do_not_depend_on_the_basis() {
    let model = brick([0.3, 0.2, 0.1], [3, 2, 2], &Material::STEEL).unwrap();
    let basis = compute_modes(&model, &ModeRequest::free_free(3), &mut |_| {}).unwrap().basis;
    let options =
        ReductionOptions { damping: Damping::ModalRatio(vec![0.01, 0.02, 0.03]), ..Default::default() };
    let body = reduce(&model, &basis, &options).unwrap();
    for (mode, zeta) in [0.01, 0.02, 0.03].into_iter().enumerate() {
        let expected = 2.0 * zeta * body.stiffness[mode][mode].sqrt();
        assert!((body.damping[mode][mode] / expected - 1.0).abs() < 1e-12);
    }
    // Mixed modes span the same space: D transforms as Θ and K do.
    let mix = [[1.0, 0.5, 0.0], [0.0, 1.0, -0.3], [0.2, 0.0, 1.0]];
    let mixing = Mat::from_fn(3, 3, |i, j| mix[i][j]);
    let mixed = ModeBasis { shapes: &basis.shapes * &mixing, modes: basis.modes.clone() };
    let mixed = reduce(&model, &mixed, &options).unwrap();
    let largest = body.damping[2][2];
    for i in 0..3 {
        for j in 0..3 {
            let expected: f64 = (0..3).map(|k| mix[k][i] * body.damping[k][k] * mix[k][j]).sum();
            let found = mixed.damping[i][j];
            assert!((found - expected).abs() < 1e-9 * largest, "({i}, {j}): {found}, expected {expected}");
        }
    }
}

#[test]
fn rayleigh_damping_is_a_sum() {
    let model = brick([0.3, 0.2, 0.1], [3, 2, 2], &Material::STEEL).unwrap();
    let basis = compute_modes(&model, &ModeRequest::free_free(2), &mut |_| {}).unwrap().basis;
    let damping = Damping::Rayleigh { alpha: 3.0, beta: 1e-5 };
    let body = reduce(&model, &basis, &ReductionOptions { damping, ..Default::default() }).unwrap();
    let expected = 3.0 + 1e-5 * body.stiffness[0][0];
    assert!((body.damping[0][0] / expected - 1.0).abs() < 1e-12);
}
