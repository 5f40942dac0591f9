//! The connecting rod with its bores held: what each basis makes of the frequencies of the full model.

use std::path::Path;

use faer::Mat;
use ffrf_fe::FeModel;
use ffrf_fe::component_modes::{ComponentRequest, Interface, NodeSelection, reduce_component_modes};
use ffrf_fe::import::{ModelFiles, NodeSource, read_model};
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_fe::reduction::{MarkerRequest, ReductionOptions, reduce};
use ffrf_model::ReducedBody;

use super::free_body::{marker_rows, mass_matrix, stiffness_matrix};
use super::parts::compute;
use super::tolerances::FREQUENCY;

fn conrod() -> FeModel {
    let deck = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/conrod/conrod.inp");
    read_model(&ModelFiles { nodes: NodeSource::Calculix(deck), mass: None, stiffness: None }).unwrap()
}

/// Frequencies of the body with the first two markers held. Units: Hz.
fn held_frequencies(body: &ReducedBody) -> Vec<f64> {
    let rows = marker_rows(body, 2);
    let basis = rows.transpose().to_owned().qr().compute_Q();
    let admissible = basis.get(.., rows.nrows()..).to_owned();
    let mass = admissible.transpose() * mass_matrix(&body.inertia) * &admissible;
    let stiffness = admissible.transpose() * stiffness_matrix(body) * &admissible;
    let lower = mass.llt(faer::Side::Lower).unwrap();
    let lower = lower.L().to_owned();
    let mut reduced = stiffness;
    for _ in 0..2 {
        faer::linalg::triangular_solve::solve_lower_triangular_in_place(
            lower.as_ref(),
            reduced.as_mut(),
            faer::Par::Seq,
        );
        reduced = reduced.transpose().to_owned();
    }
    let symmetric: Mat<f64> =
        Mat::from_fn(reduced.nrows(), reduced.ncols(), |i, j| 0.5 * (reduced[(i, j)] + reduced[(j, i)]));
    let values = symmetric.self_adjoint_eigenvalues(faer::Side::Lower).unwrap();
    values.into_iter().map(|value| value.max(0.0).sqrt() / std::f64::consts::TAU).collect()
}

#[test]
fn bores_held_rigidly_are_exact_with_craig_bampton_and_far_off_with_free_free_modes() {
    let model = conrod();
    let bore = |name: &str| NodeSelection::Set(name.to_owned()).rows(&model.nodes).unwrap();
    let (big, small) = (bore("BIG_END"), bore("SMALL_END"));
    let clamp = big.iter().chain(&small).copied().collect();
    let exact: Vec<f64> = compute_modes(&model, &ModeRequest::clamped(6, clamp), &mut |_| {})
        .unwrap()
        .report
        .modes
        .iter()
        .map(|mode| mode.frequency_hz.unwrap())
        .collect();

    let interfaces = vec![
        Interface::rigid(&model, "BIG_END", &big).unwrap(),
        Interface::rigid(&model, "SMALL_END", &small).unwrap(),
    ];
    let modes = compute(&model, &ComponentRequest::craig_bampton(interfaces, 6));
    let body = reduce_component_modes(&model, &modes, &ReductionOptions::default()).unwrap();
    assert_eq!(body.mode_count(), 12);
    let held = held_frequencies(&body);
    println!("exact {exact:?}\nCraig-Bampton {held:?}");
    for (found, wanted) in held.iter().zip(&exact) {
        assert!((found / wanted - 1.0).abs() < FREQUENCY, "{found} Hz, full model {wanted} Hz");
    }

    // As many free-free modes, held by the same markers: the mean of each bore stands still, not the bore.
    let marker = |name: &str, nodes: &[usize]| MarkerRequest { name: name.to_owned(), nodes: nodes.to_vec() };
    let options = ReductionOptions {
        markers: vec![marker("BIG_END", &big), marker("SMALL_END", &small)],
        ..ReductionOptions::default()
    };
    let errors: Vec<f64> = [14, 28]
        .map(|count| {
            let free = compute_modes(&model, &ModeRequest::free_free(count), &mut |_| {}).unwrap();
            let held = held_frequencies(&reduce(&model, &free.basis, &options).unwrap());
            println!("free-free, {count} modes: {held:?}");
            (held[0] / exact[0] - 1.0).abs()
        })
        .to_vec();
    println!("error of the first frequency: {errors:?}");
    assert!(errors.iter().all(|error| *error > 1e-3), "free-free modes cannot hold the bores: {errors:?}");
}
