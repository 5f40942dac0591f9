//! Inputs that are refused, with the number that shows why.

use faer::Mat;
use faer::sparse::Triplet;
use ffrf_fe::elements::{Material, brick};
use ffrf_fe::modes::{ModeRequest, compute_modes, user_modes};
use ffrf_fe::reduction::{Damping, MarkerRequest, ReductionOptions, reduce};
use ffrf_fe::{FeModel, SparseMatrix};

fn small() -> FeModel {
    brick([0.3, 0.2, 0.1], [3, 2, 2], &Material::STEEL).unwrap()
}

fn refusal(model: &FeModel, request: &ModeRequest) -> String {
    compute_modes(model, request, &mut |_| {}).unwrap_err().to_string()
}

#[test]
fn modes_without_stiffness() {
    let model = FeModel { stiffness: None, ..small() };
    assert!(refusal(&model, &ModeRequest::free_free(1)).contains("stiffness matrix"));
}

#[test]
fn more_modes_than_the_model_has() {
    let message = refusal(&small(), &ModeRequest::free_free(1000));
    assert!(message.contains("1000") && message.contains("102"), "{message}");
}

#[test]
fn clamps_that_do_not_exist() {
    assert!(refusal(&small(), &ModeRequest::clamped(1, vec![])).contains("at least one node"));
    assert!(refusal(&small(), &ModeRequest::clamped(1, vec![36])).contains("36"));
}

#[test]
fn a_stiffness_that_resists_rigid_motion() {
    let mut model = small();
    let stiffness = model.stiffness.take().unwrap();
    let mut triplets: Vec<Triplet<usize, usize, f64>> =
        stiffness.triplet_iter().map(|entry| Triplet::new(entry.row, entry.col, *entry.val)).collect();
    triplets.push(Triplet::new(0, 0, 1e9));
    model.stiffness = Some(SparseMatrix::try_new_from_triplets(108, 108, &triplets).unwrap());
    assert!(refusal(&model, &ModeRequest::free_free(1)).contains("resists rigid motion"));
}

#[test]
fn mode_shapes_of_a_wrong_size_or_not_finite() {
    let message = user_modes(&small(), Mat::zeros(100, 2)).unwrap_err().to_string();
    assert!(message.contains("108") && message.contains("100"), "{message}");
    let mut shapes = Mat::zeros(108, 1);
    shapes[(7, 0)] = f64::NAN;
    assert!(user_modes(&small(), shapes).unwrap_err().to_string().contains("row 7"));
}

#[test]
fn modes_that_are_rigid_motion() {
    let model = small();
    let translation = Mat::from_fn(108, 1, |dof, _| if dof % 3 == 0 { 1.0 } else { 0.0 });
    let basis = user_modes(&model, translation).unwrap().basis;
    let message = reduce(&model, &basis, &ReductionOptions::default()).unwrap_err().to_string();
    assert!(message.contains("rigid"), "{message}");
}

#[test]
fn modal_stiffness_damping_and_markers_that_do_not_fit() {
    let model = small();
    let basis = compute_modes(&model, &ModeRequest::free_free(2), &mut |_| {}).unwrap().basis;
    let refuse = |options: ReductionOptions| reduce(&model, &basis, &options).unwrap_err().to_string();
    let message = refuse(ReductionOptions { modal_stiffness: Some(Mat::zeros(3, 3)), ..Default::default() });
    assert!(message.contains("2 x 2") && message.contains("3 x 3"), "{message}");
    let lopsided = Mat::from_fn(2, 2, |i, j| [[1.0, 0.5], [0.0, 1.0]][i][j]);
    assert!(
        refuse(ReductionOptions { modal_stiffness: Some(lopsided), ..Default::default() })
            .contains("symmetric")
    );
    let damping = Damping::ModalRatio(vec![0.1; 3]);
    assert!(refuse(ReductionOptions { damping, ..Default::default() }).contains("found 3"));
    let damping = Damping::Rayleigh { alpha: -1.0, beta: 0.0 };
    assert!(refuse(ReductionOptions { damping, ..Default::default() }).contains("-1"));
    let on_a_line = vec![MarkerRequest { name: "edge".to_owned(), nodes: vec![0, 1, 2] }];
    assert!(refuse(ReductionOptions { markers: on_a_line, ..Default::default() }).contains("`edge`"));
    let beyond = vec![MarkerRequest { name: "far".to_owned(), nodes: vec![99] }];
    assert!(refuse(ReductionOptions { markers: beyond, ..Default::default() }).contains("99"));
}
