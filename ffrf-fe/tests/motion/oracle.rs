//! The node-by-node oracle against numerical differentiation of the motion of the nodes.
#![allow(clippy::unwrap_used)]

use faer::Mat;
use faer::sparse::{SparseColMat, Triplet};
use ffrf_fe::oracle::{Oracle, OracleState};
use ffrf_fe::{FeModel, ModeBasis, Nodes};
use ffrf_model::{Mode, ModeKind};

const NODES: usize = 4;
const MODES: usize = 2;

/// Central differences with this step leave errors of the order of its square (and round-off over it).
const STEP: f64 = 1e-4;
/// Second differences in steps of 1e-4: 1e-8 from truncation, 1e-16 / 1e-8 from round-off.
const DIFFERENCE_ERROR: f64 = 1e-6;
/// Two ways to the same sums of a few dozen products.
const ROUND_OFF: f64 = 1e-13;

/// Some number in [-1, 1], the same on every machine.
fn number(index: usize) -> f64 {
    ((index * index + 17 * index + 5) % 101) as f64 / 50.0 - 1.0
}

fn matrix(size: usize, entry: impl Fn(usize, usize) -> f64) -> SparseColMat<usize, f64> {
    let triplets: Vec<_> =
        (0..size * size).map(|k| Triplet::new(k / size, k % size, entry(k / size, k % size))).collect();
    SparseColMat::try_new_from_triplets(size, size, &triplets).unwrap()
}

/// Symmetric, dominated by its diagonal.
fn symmetric(size: usize) -> impl Fn(usize, usize) -> f64 {
    move |i, j| if i == j { 3.0 + number(i) } else { 0.2 * number(i + j + i * j) / size as f64 }
}

fn model() -> (FeModel, ModeBasis) {
    let model = FeModel {
        nodes: Nodes {
            ids: (0..NODES as u64).collect(),
            positions: (0..NODES).map(|n| [number(3 * n), number(3 * n + 1), number(3 * n + 2)]).collect(),
            ..Nodes::default()
        },
        mass: matrix(NODES, symmetric(NODES)),
        mass_anisotropy: 0.0,
        stiffness: Some(matrix(3 * NODES, symmetric(3 * NODES))),
        fixed_dofs: vec![],
        elements: vec![],
        materials: vec![],
        element_materials: vec![],
        sources: vec![],
        notes: vec![],
    };
    let basis = ModeBasis {
        shapes: Mat::from_fn(3 * NODES, MODES, |row, column| number(40 + 7 * row + 31 * column)),
        modes: vec![Mode { kind: ModeKind::User, frequency_hz: None }; MODES],
    };
    (model, basis)
}

fn state() -> OracleState {
    OracleState {
        q: vec![0.3, -0.2],
        velocity: [0.5, -1.0, 0.25],
        omega: [0.7, 0.4, -1.1],
        q_dot: vec![-0.6, 0.9],
    }
}

/// Rodrigues' formula: `vector` turned by the rotation vector `turn`.
fn rotate(turn: [f64; 3], vector: [f64; 3]) -> [f64; 3] {
    let angle = turn.iter().map(|x| x * x).sum::<f64>().sqrt();
    if angle == 0.0 {
        return vector;
    }
    let axis = turn.map(|x| x / angle);
    let along: f64 = (0..3).map(|i| axis[i] * vector[i]).sum();
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let crossed = axis[j] * vector[k] - axis[k] * vector[j];
        vector[i] * angle.cos() + crossed * angle.sin() + axis[i] * along * (1.0 - angle.cos())
    })
}

/// Inertial node positions at time `t` when the frame origin, the spin and the modal rates are uniform.
fn nodes_at(model: &FeModel, basis: &ModeBasis, state: &OracleState, t: f64) -> Vec<f64> {
    (0..NODES)
        .flat_map(|n| {
            let local = std::array::from_fn(|i| {
                let shape = |mu: usize| basis.shapes[(3 * n + i, mu)] * (state.q[mu] + t * state.q_dot[mu]);
                model.nodes.positions[n][i] + (0..MODES).map(shape).sum::<f64>()
            });
            let turned = rotate(state.omega.map(|x| t * x), local);
            (0..3).map(move |i| t * state.velocity[i] + turned[i])
        })
        .collect()
}

fn unit(index: usize) -> OracleState {
    let mut unit = OracleState { velocity: [0.0; 3], omega: [0.0; 3], q_dot: vec![0.0; MODES], ..state() };
    match index {
        0..3 => unit.velocity[index] = 1.0,
        3..6 => unit.omega[index - 3] = 1.0,
        _ => unit.q_dot[index - 6] = 1.0,
    }
    unit
}

/// ∂(node velocities)/∂(velocity `index`), by differences.
fn column(model: &FeModel, basis: &ModeBasis, index: usize) -> Vec<f64> {
    let unit = unit(index);
    let (after, before) = (nodes_at(model, basis, &unit, STEP), nodes_at(model, basis, &unit, -STEP));
    after.iter().zip(before).map(|(a, b)| (a - b) / (2.0 * STEP)).collect()
}

/// aᵀ (M_s ⊗ I3) b
fn mass_product(a: &[f64], b: &[f64]) -> f64 {
    let mass = symmetric(NODES);
    let entry = |n: usize, m: usize| {
        (0..3).map(|i| a[3 * n + i] * b[3 * m + i]).sum::<f64>() * mass(n.max(m), n.min(m))
    };
    (0..NODES * NODES).map(|k| entry(k / NODES, k % NODES)).sum()
}

#[track_caller]
fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() < tolerance, "{found} instead of {expected}");
}

#[test]
fn mass_matrix_and_gyroscopic_forces_follow_from_the_motion_of_the_nodes() {
    let (model, basis) = model();
    let values = Oracle::new(&model, &basis).unwrap().evaluate(&state());
    let columns: Vec<_> = (0..6 + MODES).map(|index| column(&model, &basis, index)).collect();
    let at = |t| nodes_at(&model, &basis, &state(), t);
    let acceleration: Vec<f64> =
        (0..3 * NODES).map(|k| (at(STEP)[k] - 2.0 * at(0.0)[k] + at(-STEP)[k]) / (STEP * STEP)).collect();
    for i in 0..6 + MODES {
        for j in 0..6 + MODES {
            assert_close(values.mass_matrix[i][j], mass_product(&columns[i], &columns[j]), DIFFERENCE_ERROR);
        }
        assert_close(
            values.quadratic_velocity[i],
            mass_product(&columns[i], &acceleration),
            DIFFERENCE_ERROR,
        );
    }
}

#[test]
fn energy_and_momenta_follow_from_the_mass_matrix() {
    let (model, basis) = model();
    let state = state();
    let values = Oracle::new(&model, &basis).unwrap().evaluate(&state);
    let velocity: Vec<f64> = [&state.velocity[..], &state.omega, &state.q_dot].concat();
    let momentum: Vec<f64> =
        values.mass_matrix.iter().map(|row| row.iter().zip(&velocity).map(|(m, v)| m * v).sum()).collect();
    let twice: f64 = momentum.iter().zip(&velocity).map(|(p, v)| p * v).sum();
    assert_close(values.kinetic_energy, 0.5 * twice, ROUND_OFF * twice);
    for i in 0..3 {
        assert_close(values.linear_momentum[i], momentum[i], ROUND_OFF * twice);
        assert_close(values.angular_momentum[i], momentum[3 + i], ROUND_OFF * twice);
    }
}

#[test]
fn elastic_forces_are_the_gradient_of_the_elastic_energy() {
    let (model, basis) = model();
    let oracle = Oracle::new(&model, &basis).unwrap();
    let energy = |q: Vec<f64>| oracle.evaluate(&OracleState { q, ..state() }).elastic.unwrap();
    let here = energy(state().q);
    for mu in 0..MODES {
        let shifted = |step: f64| {
            let mut q = state().q;
            q[mu] += step;
            energy(q).energy
        };
        // The energy is quadratic: central differences have no truncation error.
        assert_close(
            here.force[mu],
            (shifted(0.5) - shifted(-0.5)) / 1.0,
            ROUND_OFF * here.absolute_energy.max(1.0) * 1e2,
        );
    }
    assert!(here.absolute_energy >= here.energy && here.energy > 0.0);
}

#[test]
fn scales_bound_what_they_scale() {
    let (model, basis) = model();
    let oracle = Oracle::new(&model, &basis).unwrap();
    let values = oracle.evaluate(&state());
    let group = ffrf_fe::oracle::group_of;
    for (i, row) in values.mass_matrix.iter().enumerate() {
        let scale = values.scales.column[group(i)];
        assert!(values.quadratic_velocity[i].abs() <= scale * values.scales.convective * (1.0 + ROUND_OFF));
        for (j, entry) in row.iter().enumerate() {
            assert!(entry.abs() <= scale * values.scales.column[group(j)] * (1.0 + ROUND_OFF));
        }
    }
    assert_close(oracle.largest_displacement(&[0.0, 0.0]), 0.0, f64::MIN_POSITIVE);
}

#[test]
fn mode_shapes_of_another_mesh_are_refused() {
    let (model, mut basis) = model();
    basis.shapes = Mat::zeros(3 * NODES - 3, MODES);
    let message = Oracle::new(&model, &basis).unwrap_err().to_string();
    assert!(message.contains("expected 12 rows") && message.contains("found 9"), "{message}");
}
