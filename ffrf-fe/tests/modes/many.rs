//! Any number of modes, any multiplicity: the sparse solver beyond one block and beyond one restart.

use std::f64::consts::TAU;
use std::sync::OnceLock;

use faer::sparse::Triplet;
use ffrf_fe::elements::{Material, brick};
use ffrf_fe::modes::{Method, ModeRequest, ModeSolution, compute_modes};
use ffrf_fe::{FeModel, Nodes, SparseMatrix};
use proptest::prelude::*;

use crate::tolerances::{ORTHOGONALITY, TWO_SOLVERS, WHOLE_SPECTRUM};

fn solve(model: &FeModel, request: &ModeRequest) -> ModeSolution {
    let solution = compute_modes(model, request, &mut |_| {}).unwrap();
    let report = &solution.report;
    assert_eq!(report.modes.len(), request.count);
    assert_eq!(report.counted, Some(report.found), "{}", report.method);
    assert!(report.orthogonality_error < ORTHOGONALITY, "{:e}", report.orthogonality_error);
    solution
}

/// ω² of every mode.
fn eigenvalues(solution: &ModeSolution) -> Vec<f64> {
    solution.report.modes.iter().map(|mode| (TAU * mode.frequency_hz.unwrap()).powi(2)).collect()
}

fn sparse(request: ModeRequest) -> ModeRequest {
    ModeRequest { method: Method::Sparse, ..request }
}

/// A brick without any symmetry but that of its edges: 540 degrees of freedom, 534 elastic modes.
fn brick_and_spectrum() -> &'static (FeModel, Vec<f64>) {
    static BRICK: OnceLock<(FeModel, Vec<f64>)> = OnceLock::new();
    BRICK.get_or_init(|| {
        let model = brick([0.8, 0.2, 0.1], [11, 4, 2], &Material::STEEL).unwrap();
        let request = ModeRequest { method: Method::Dense, ..ModeRequest::free_free(3 * 180 - 6) };
        let spectrum = eigenvalues(&solve(&model, &request));
        (model, spectrum)
    })
}

#[test]
fn every_number_of_modes_of_a_small_part() {
    let model = brick([0.3, 0.2, 0.1], [2, 1, 1], &Material::STEEL).unwrap();
    let all = eigenvalues(&solve(&model, &ModeRequest::free_free(30)));
    for count in 1..30 {
        let some = eigenvalues(&solve(&model, &ModeRequest::free_free(count)));
        for (a, b) in some.iter().zip(&all) {
            assert!((a - b).abs() <= WHOLE_SPECTRUM * all[29], "{count} modes: {a:e} {b:e}");
        }
    }
    let error = compute_modes(&model, &ModeRequest::free_free(31), &mut |_| {}).unwrap_err().to_string();
    assert!(error.contains("31") && error.contains("30"), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_sparse_solver_finds_the_start_of_the_dense_spectrum(count in 1_usize..110) {
        let (model, spectrum) = brick_and_spectrum();
        let solution = solve(model, &sparse(ModeRequest::free_free(count)));
        prop_assert!(solution.report.method.contains("Lanczos"));
        for (found, expected) in eigenvalues(&solution).iter().zip(spectrum) {
            let error = (found - expected).abs();
            prop_assert!(
                error <= TWO_SOLVERS * expected + WHOLE_SPECTRUM * spectrum[533],
                "{} {}", found, expected
            );
        }
    }
}

/// Copies of a part beside each other, the stiffness of each scaled by `1 + spread * number`.
fn copies(part: &FeModel, count: usize, spread: f64) -> FeModel {
    let nodes = part.nodes.len();
    let place = |matrix: &SparseMatrix, size: usize, scale: &dyn Fn(usize) -> f64| {
        let triplets: Vec<Triplet<usize, usize, f64>> = (0..count)
            .flat_map(|copy| {
                matrix.triplet_iter().map(move |entry| {
                    Triplet::new(copy * size + entry.row, copy * size + entry.col, entry.val * scale(copy))
                })
            })
            .collect();
        SparseMatrix::try_new_from_triplets(count * size, count * size, &triplets).unwrap()
    };
    let positions = (0..count)
        .flat_map(|copy| part.nodes.positions.iter().map(move |p| [p[0], p[1], p[2] + copy as f64]))
        .collect();
    FeModel {
        nodes: Nodes { ids: (0..(count * nodes) as u64).collect(), positions, ..Nodes::default() },
        mass: place(&part.mass, nodes, &|_| 1.0),
        stiffness: part
            .stiffness
            .as_ref()
            .map(|stiffness| place(stiffness, 3 * nodes, &|copy| 1.0 + spread * copy as f64)),
        ..part.clone()
    }
}

fn clamped_copies(count: usize, spread: f64) -> (FeModel, FeModel) {
    let part = brick([0.5, 0.1, 0.1], [5, 1, 1], &Material::STEEL).unwrap();
    (copies(&part, count, spread), part)
}

fn roots(model: &FeModel) -> Vec<usize> {
    (0..model.nodes.len()).filter(|&node| model.nodes.positions[node][0] == 0.0).collect()
}

#[test]
fn multiplicities_beyond_the_block_are_found() {
    // Bending in two planes, ten beams: the first eigenvalue is repeated twenty times.
    let (model, part) = clamped_copies(10, 0.0);
    let single = eigenvalues(&solve(&part, &ModeRequest::clamped(6, roots(&part))));
    let found = eigenvalues(&solve(&model, &sparse(ModeRequest::clamped(60, roots(&model)))));
    for (number, value) in found.iter().enumerate() {
        let expected = single[number / 10];
        assert!((value - expected).abs() <= TWO_SOLVERS * expected, "mode {}: {value:e}", number + 1);
    }
}

#[test]
fn clustered_eigenvalues_are_told_apart() {
    let spread = 1e-6;
    let (model, part) = clamped_copies(10, spread);
    let single = eigenvalues(&solve(&part, &ModeRequest::clamped(3, roots(&part))));
    let mut expected: Vec<f64> = single
        .iter()
        .flat_map(|value| (0..10).map(move |copy| value * (1.0 + spread * copy as f64)))
        .collect();
    expected.sort_by(f64::total_cmp);
    // The request ends within the second cluster.
    let found = eigenvalues(&solve(&model, &sparse(ModeRequest::clamped(25, roots(&model)))));
    for (number, (value, expected)) in found.iter().zip(&expected).enumerate() {
        assert!((value - expected).abs() <= TWO_SOLVERS * expected, "mode {}: {value:e}", number + 1);
    }
}

#[test]
fn a_model_with_few_masses_has_no_more_modes_than_they_allow() {
    let (model, _) = brick_and_spectrum();
    let mut model = model.clone();
    let triplets: Vec<Triplet<usize, usize, f64>> =
        (0..180).step_by(9).map(|node| Triplet::new(node, node, 0.1)).collect();
    model.mass = SparseMatrix::try_new_from_triplets(180, 180, &triplets).unwrap();
    let dense = ModeRequest { method: Method::Dense, ..ModeRequest::free_free(54) };
    let expected = eigenvalues(&solve(&model, &dense));
    let solution = solve(&model, &sparse(ModeRequest::free_free(54)));
    assert!(solution.report.method.contains("Lanczos"), "{}", solution.report.method);
    for (found, expected) in eigenvalues(&solution).iter().zip(&expected) {
        assert!((found - expected).abs() <= TWO_SOLVERS * expected, "{found:e} {expected:e}");
    }
    let error =
        compute_modes(&model, &sparse(ModeRequest::free_free(60)), &mut |_| {}).unwrap_err().to_string();
    assert!(error.contains("60") && error.contains("54"), "{error}");
}

#[test]
fn many_modes_do_not_depend_on_threads() {
    let (model, _) = brick_and_spectrum();
    let request = sparse(ModeRequest::free_free(100));
    let one = solve(model, &ModeRequest { threads: 1, ..request.clone() });
    let two = solve(model, &request);
    for j in 0..100 {
        assert_eq!(one.basis.shapes.col_as_slice(j), two.basis.shapes.col_as_slice(j), "mode {}", j + 1);
    }
}
