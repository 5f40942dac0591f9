//! Section forces: the load on one side of a cut, the stresses inside of the elements, and the balance of both sides.

use faer::linalg::solvers::Solve;
use faer::sparse::Triplet;
use faer::{Mat, Side};
use ffrf_fe::elements::{Material, quadratic_brick};
use ffrf_fe::modes::{ModeRequest, compute_modes};
use ffrf_fe::section::{SectionError, SectionRequest, section_marker};
use ffrf_fe::{Elasticity, FeError, FeModel, ModeBasis, SparseMatrix};
use ffrf_model::{Mode, ModeKind, SectionMarker, Vector3};

pub const STEEL: Material = Material { youngs_modulus: 210e9, poisson_ratio: 0.3, density: 7850.0 };
const EDGES: [f64; 3] = [0.5, 0.05, 0.03];

/// Round-off of a static solution beside the load that it is of.
const SOLVED: f64 = 1e-8;
/// Round-off of sums over the elements of a cut, beside the largest sum.
const SUMMED: f64 = 1e-10;

fn part() -> FeModel {
    quadratic_brick(EDGES, [5, 1, 1], &STEEL).expect("a sound mesh")
}

fn cut(model: &FeModel, basis: &ModeBasis, point: Vector3, normal: Vector3) -> SectionMarker {
    let request = SectionRequest { name: "cut".to_owned(), point, normal };
    section_marker(model, basis, &request).expect("a cut")
}

fn cross(a: Vector3, b: Vector3) -> Vector3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// K u = f, with the nodes at x = 0 held.
pub fn at_rest(model: &FeModel, force: &[f64]) -> ModeBasis {
    let size = force.len();
    let held = |dof: usize| model.nodes.positions[dof / 3][0] == 0.0;
    let free: Vec<usize> = (0..size).filter(|&dof| !held(dof)).collect();
    let mut place = vec![None; size];
    free.iter().enumerate().for_each(|(k, &dof)| place[dof] = Some(k));
    let entries = model.stiffness.as_ref().expect("a stiffness").triplet_iter();
    let entries =
        entries.filter_map(|entry| Some(Triplet::new(place[entry.row]?, place[entry.col]?, *entry.val)));
    let entries: Vec<Triplet<usize, usize, f64>> = entries.collect();
    let reduced = SparseMatrix::try_new_from_triplets(free.len(), free.len(), &entries).expect("a matrix");
    let right = Mat::from_fn(free.len(), 1, |i, _| force[free[i]]);
    let solved = reduced.sp_cholesky(Side::Lower).expect("positive definite").solve(&right);
    let mut shapes = Mat::zeros(size, 1);
    for (i, &dof) in free.iter().enumerate() {
        shapes[(dof, 0)] = solved[(i, 0)];
    }
    ModeBasis { shapes, modes: vec![Mode { kind: ModeKind::User, frequency_hz: None }] }
}

#[test]
fn a_cantilever_transmits_the_load_at_its_tip() {
    let model = part();
    let load: Vector3 = [3000.0, -200.0, 500.0];
    let tip: Vec<usize> =
        (0..model.nodes.len()).filter(|&row| model.nodes.positions[row][0] == EDGES[0]).collect();
    let mut force = vec![0.0; 3 * model.nodes.len()];
    for &row in &tip {
        for k in 0..3 {
            force[3 * row + k] += load[k] / tip.len() as f64;
        }
    }
    let basis = at_rest(&model, &force);
    for x in [0.02, 0.11, 0.26, 0.3, 0.49] {
        let point = [x, 0.01, 0.02];
        let found = cut(&model, &basis, point, [2.0, 0.0, 0.0]);
        assert_eq!(found.normal, [1.0, 0.0, 0.0]);
        let mut expected = [0.0; 6];
        for &row in &tip {
            let arm = std::array::from_fn(|k| model.nodes.positions[row][k] - point[k]);
            let share = load.map(|f| f / tip.len() as f64);
            let moment = cross(arm, share);
            for k in 0..3 {
                expected[k] += share[k];
                expected[3 + k] += moment[k];
            }
        }
        for k in 0..6 {
            let off = (found.force[0][k] - expected[k]).abs();
            assert!(off < SOLVED * 3000.0, "at {x}, {k}: {} {}", found.force[0][k], expected[k]);
        }
        // F times the distance, as every textbook has it.
        let about_z = load[1] * (EDGES[0] - x) - load[0] * (0.5 * EDGES[1] - point[1]);
        assert!((found.force[0][5] - about_z).abs() < SOLVED * 3000.0, "{} {about_z}", found.force[0][5]);
    }
}

/// ∫ σ · ∇N of the nodes on one side, element by element: what the elements that are cut exert, without the stiffness matrix.
fn of_elements(model: &FeModel, basis: &ModeBasis, mode: usize, marker: &SectionMarker) -> [f64; 6] {
    let elasticity = Elasticity { youngs_modulus: STEEL.youngs_modulus, poisson_ratio: STEEL.poisson_ratio };
    let arm = |row: usize| -> Vector3 {
        std::array::from_fn(|k| model.nodes.positions[row][k] - marker.position[k])
    };
    let is_before = |row: usize| (0..3).map(|k| arm(row)[k] * marker.normal[k]).sum::<f64>() > 0.0;
    let mut sums = [0.0; 6];
    for element in &model.elements {
        if element.nodes.iter().all(|&row| is_before(row)) {
            continue;
        }
        let corners: Vec<Vector3> = element.nodes.iter().map(|&row| model.nodes.positions[row]).collect();
        for point in ffrf_fe::elements::quadrature(element.kind, &corners).expect("a sound element") {
            let slope: [Vector3; 3] = std::array::from_fn(|i| {
                std::array::from_fn(|k| {
                    let nodes = element.nodes.iter().zip(&point.gradient);
                    nodes.map(|(&row, g)| basis.shapes[(3 * row + i, mode)] * g[k]).sum()
                })
            });
            let [xx, yy, zz, xy, xz, yz] = elasticity.stress(&slope);
            let stress = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
            for (&row, g) in element.nodes.iter().zip(&point.gradient).filter(|(row, _)| is_before(**row)) {
                let force: Vector3 =
                    stress.map(|line| point.volume * (0..3).map(|k| line[k] * g[k]).sum::<f64>());
                let moment = cross(arm(row), force);
                for k in 0..3 {
                    sums[k] += force[k];
                    sums[3 + k] += moment[k];
                }
            }
        }
    }
    sums
}

#[test]
fn modes_transmit_what_their_stresses_say_and_both_sides_balance() {
    let model = part();
    let solution = compute_modes(&model, &ModeRequest::free_free(4), &mut |_| {}).expect("modes");
    let (point, normal): (Vector3, Vector3) = ([0.22, 0.02, 0.01], [1.0, 0.3, -0.2]);
    let marker = cut(&model, &solution.basis, point, normal);
    let other = cut(&model, &solution.basis, point, normal.map(|x| -x));
    let largest = marker.force.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    assert!(largest > 0.0);
    for mode in 0..4 {
        let expected = of_elements(&model, &solution.basis, mode, &marker);
        for k in 0..6 {
            let off = (marker.force[mode][k] - expected[k]).abs();
            assert!(off < SUMMED * largest, "mode {mode}, {k}: {} {}", marker.force[mode][k], expected[k]);
            let sum = (marker.force[mode][k] + other.force[mode][k]).abs();
            assert!(sum < SUMMED * largest, "mode {mode}, {k}: {sum:e}");
        }
    }
}

#[test]
fn what_is_no_cut_is_refused() {
    let model = part();
    let shapes = Mat::zeros(3 * model.nodes.len(), 1);
    let basis = ModeBasis { shapes, modes: vec![Mode { kind: ModeKind::User, frequency_hz: None }] };
    let refused = |point: Vector3, normal: Vector3| {
        let request = SectionRequest { name: "cut".to_owned(), point, normal };
        match section_marker(&model, &basis, &request).expect_err("no cut") {
            FeError::Section(error) => error,
            other => panic!("{other}"),
        }
    };
    let section = "cut".to_owned();
    let none = SectionError::Plane { section: section.clone() };
    assert_eq!(refused([0.0; 3], [0.0; 3]), none);
    assert_eq!(refused([f64::NAN, 0.0, 0.0], [1.0, 0.0, 0.0]), none);
    let all = model.nodes.len();
    let beside = SectionError::OneSide { section, before: 0, behind: all };
    // Nodes on the plane are behind it.
    assert_eq!(refused([EDGES[0], 0.0, 0.0], [1.0, 0.0, 0.0]), beside);
    assert!(matches!(refused([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]), SectionError::OneSide { behind: 0, .. }));
}
