//! The dense and the sparse solver on the same bricks.

use faer::sparse::Triplet;
use ffrf_fe::elements::{Material, brick};
use ffrf_fe::modes::{Method, ModeRequest, ModeSolution, compute_modes};
use ffrf_fe::reduction::{MarkerRequest, ReductionOptions, reduce};
use ffrf_fe::{FeModel, SparseMatrix};

use crate::tolerances::{ORTHOGONALITY, TWO_SOLVERS};

fn solve(model: &FeModel, request: ModeRequest) -> ModeSolution {
    let solution = compute_modes(model, &request, &mut |_| {}).unwrap();
    println!("{}", solution.report);
    assert!(solution.report.orthogonality_error < ORTHOGONALITY, "{:e}", solution.report.orthogonality_error);
    assert_eq!(solution.report.counted, Some(solution.report.found));
    solution
}

/// Both solvers on one problem; the modes must agree to the sign, repeated ones included.
fn compare(model: &FeModel, request: &ModeRequest) -> ModeSolution {
    let dense = solve(model, ModeRequest { method: Method::Dense, ..request.clone() });
    let sparse = solve(model, ModeRequest { method: Method::Sparse, ..request.clone() });
    assert!(dense.report.method.contains("dense"), "{}", dense.report.method);
    assert!(sparse.report.method.contains("Lanczos"), "{}", sparse.report.method);
    for (a, b) in dense.report.modes.iter().zip(&sparse.report.modes) {
        let (a, b) = (a.frequency_hz.unwrap(), b.frequency_hz.unwrap());
        assert!((a - b).abs() <= TWO_SOLVERS * a, "{a} Hz dense, {b} Hz sparse");
    }
    for j in 0..request.count {
        let (a, b) = (dense.basis.shapes.col_as_slice(j), sparse.basis.shapes.col_as_slice(j));
        let largest = a.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let error = a.iter().zip(b).fold(0.0_f64, |error, (x, y)| error.max((x - y).abs()));
        // Shapes are exact to the residual over the relative gap to the next frequency, about 1e-3 here.
        assert!(error <= 1e-5 * largest, "shape {}: {error:e} of {largest:e}", j + 1);
    }
    sparse
}

#[test]
fn solvers_agree_on_a_free_brick() {
    let model = brick([0.8, 0.2, 0.1], [12, 4, 3], &Material::STEEL).unwrap();
    let solution = compare(&model, &ModeRequest::free_free(8));
    assert_eq!(solution.report.rigid_modes.len(), 6);
    assert_eq!(solution.report.mechanisms, 0);
}

#[test]
fn solvers_agree_on_a_clamped_brick() {
    let model = brick([0.8, 0.2, 0.1], [12, 4, 3], &Material::STEEL).unwrap();
    let clamp = (0..model.nodes.len()).filter(|&node| model.nodes.positions[node][0] == 0.0).collect();
    let solution = compare(&model, &ModeRequest::clamped(8, clamp));
    assert!(solution.report.rigid_modes.is_empty());
    let (mut mass, mut inertia) = ([0.0; 3], [0.0; 3]);
    for mode in &solution.report.modes {
        for i in 0..3 {
            mass[i] += mode.effective_mass[i];
            inertia[i] += mode.effective_inertia[i];
        }
    }
    for i in 0..3 {
        assert!(mass[i] > 0.0 && mass[i] <= solution.report.total_mass, "effective mass {mass:?}");
        assert!(
            inertia[i] > 0.0 && inertia[i] <= solution.report.total_inertia[i],
            "effective inertia {inertia:?}"
        );
    }
}

#[test]
fn repeated_frequencies_of_a_square_brick_come_in_pairs_along_the_axes() {
    let model = brick([0.1, 0.1, 0.8], [4, 4, 12], &Material::STEEL).unwrap();
    let solution = compare(&model, &ModeRequest::free_free(5));
    let frequency: Vec<f64> = solution.report.modes.iter().map(|mode| mode.frequency_hz.unwrap()).collect();
    assert!((frequency[1] - frequency[0]).abs() < 1e-8 * frequency[0], "{frequency:?}");
    // The first of a bending pair moves along x, the second along y.
    let share = |mode: usize, axis: usize| -> f64 {
        let column = solution.basis.shapes.col_as_slice(mode);
        let total: f64 = column.iter().map(|x| x * x).sum();
        column.iter().skip(axis).step_by(3).map(|x| x * x).sum::<f64>() / total
    };
    assert!(share(0, 0) > 0.8 && share(0, 1) < 0.01, "{} {}", share(0, 0), share(0, 1));
    assert!(share(1, 1) > 0.8 && share(1, 0) < 0.01, "{} {}", share(1, 0), share(1, 1));
}

#[test]
fn a_cut_pair_is_noted() {
    let model = brick([0.1, 0.1, 0.8], [3, 3, 8], &Material::STEEL).unwrap();
    assert!(solve(&model, ModeRequest::free_free(1)).report.cut_repeated);
    assert!(!solve(&model, ModeRequest::free_free(2)).report.cut_repeated);
}

#[test]
fn results_do_not_depend_on_threads_or_repetition() {
    let model = brick([0.3, 0.2, 0.2], [9, 6, 6], &Material::STEEL).unwrap();
    let request = ModeRequest { method: Method::Sparse, ..ModeRequest::free_free(6) };
    let one = solve(&model, ModeRequest { threads: 1, ..request.clone() });
    let two = solve(&model, ModeRequest { threads: 2, ..request.clone() });
    let again = solve(&model, request);
    for other in [&two, &again] {
        for j in 0..6 {
            assert_eq!(
                one.basis.shapes.col_as_slice(j),
                other.basis.shapes.col_as_slice(j),
                "mode {}",
                j + 1
            );
        }
    }
}

/// The brick with its mass lumped to the diagonal, and nodes of a row without mass.
fn lumped_without(model: &FeModel, massless: &[usize]) -> SparseMatrix {
    let triplets: Vec<Triplet<usize, usize, f64>> = (0..model.nodes.len())
        .filter(|node| !massless.contains(node))
        .map(|node| Triplet::new(node, node, model.mass.val_of_col(node).iter().sum()))
        .collect();
    SparseMatrix::try_new_from_triplets(model.nodes.len(), model.nodes.len(), &triplets).unwrap()
}

#[test]
fn nodes_without_mass_follow_statically() {
    let mut model = brick([0.8, 0.2, 0.1], [12, 4, 3], &Material::STEEL).unwrap();
    model.mass = lumped_without(&model, &[0, 17, 100]);
    let solution = compare(&model, &ModeRequest::free_free(6));
    assert_eq!(solution.report.loose_dofs, 0);
    assert!(solution.basis.shapes[(0, 0)] != 0.0);
}

#[test]
fn nodes_without_mass_and_stiffness_stay_at_rest() {
    let mut model = brick([0.8, 0.2, 0.1], [12, 4, 3], &Material::STEEL).unwrap();
    let before = solve(&model, ModeRequest::free_free(3));
    let nodes = model.nodes.len();
    model.nodes.ids.push(9999);
    model.nodes.positions.push([0.4, 0.1, 0.5]);
    model.mass = grown(&model.mass, nodes + 1);
    model.stiffness = model.stiffness.map(|stiffness| grown(&stiffness, 3 * (nodes + 1)));
    let after = solve(&model, ModeRequest::free_free(3));
    assert_eq!(after.report.loose_dofs, 3);
    assert_eq!(after.basis.shapes.nrows(), 3 * (nodes + 1));
    let marker = MarkerRequest { name: "loose".to_owned(), nodes: vec![nodes] };
    let options = ReductionOptions { markers: vec![marker], ..ReductionOptions::default() };
    let message = reduce(&model, &after.basis, &options).unwrap_err().to_string();
    assert!(message.contains("9999"), "{message}");
    for (a, b) in before.report.modes.iter().zip(&after.report.modes) {
        let (a, b) = (a.frequency_hz.unwrap(), b.frequency_hz.unwrap());
        assert!((a - b).abs() <= TWO_SOLVERS * a, "{a} Hz without, {b} Hz with the loose node");
    }
}

fn grown(matrix: &SparseMatrix, size: usize) -> SparseMatrix {
    let triplets: Vec<Triplet<usize, usize, f64>> =
        matrix.triplet_iter().map(|entry| Triplet::new(entry.row, entry.col, *entry.val)).collect();
    SparseMatrix::try_new_from_triplets(size, size, &triplets).unwrap()
}
