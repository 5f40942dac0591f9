//! Natural frequencies of the whole finite-element assembly: K φ = λ M φ on the coordinates that joints leave, by subspace iteration.

use faer::linalg::solvers::Solve;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};
use ffrf_fe::SparseMatrix;
use ffrf_test_kit::random::Random;

use super::structure::{Motion, Structure};

/// Iterations: with twice as many shapes as are sought, each gains a digit.
const ITERATIONS: usize = 14;

/// The lowest `count` frequencies. Units: Hz.
pub fn frequencies(structure: &Structure, count: usize) -> Vec<f64> {
    let (stiffness, mass) = assemble(structure);
    let size = stiffness.nrows();
    let factor = stiffness.sp_cholesky(Side::Lower).unwrap();
    let width = (2 * count + 8).min(size);
    // A start that favours no mode.
    let mut random = Random::new(1);
    let mut shapes = Mat::from_fn(size, width, |_, _| random.number());
    let mut values = Vec::new();
    for _ in 0..ITERATIONS {
        shapes = factor.solve(&mass * &shapes);
        let (found, rotation) = ritz(&stiffness, &mass, &shapes);
        shapes = &shapes * rotation;
        values = found;
    }
    let last = values.clone();
    shapes = factor.solve(&mass * &shapes);
    let (values, _) = ritz(&stiffness, &mass, &shapes);
    for (before, after) in last.iter().zip(&values).take(count) {
        assert!((before / after - 1.0).abs() < 1e-9, "the subspace has not settled: {before} {after}");
    }
    values.iter().take(count).map(|value| value.sqrt() / std::f64::consts::TAU).collect()
}

/// Eigenvalues of the projected problem, ascending, and the factors of its shapes with unit mass.
fn ritz(stiffness: &SparseMatrix, mass: &SparseMatrix, shapes: &Mat<f64>) -> (Vec<f64>, Mat<f64>) {
    let projected = |matrix: &SparseMatrix| {
        let full = shapes.transpose() * (matrix * shapes);
        Mat::from_fn(full.nrows(), full.ncols(), |i, j| 0.5 * (full[(i, j)] + full[(j, i)]))
    };
    let mass = projected(mass).self_adjoint_eigen(Side::Lower).unwrap();
    let count = shapes.ncols();
    let half = Mat::from_fn(count, count, |i, j| mass.U()[(i, j)] / mass.S().column_vector()[j].sqrt());
    let turned = half.transpose() * projected(stiffness) * &half;
    let symmetric = Mat::from_fn(count, count, |i, j| 0.5 * (turned[(i, j)] + turned[(j, i)]));
    let eigen = symmetric.self_adjoint_eigen(Side::Lower).unwrap();
    let values = (0..count).map(|k| eigen.S().column_vector()[k]).collect();
    (values, &half * eigen.U())
}

/// What a motion of an interface is in the coordinates of the assembly: a column, or none if it is held.
struct Columns {
    /// First column of each part's free nodes by node, `None` for nodes of interfaces.
    nodes: Vec<Vec<Option<usize>>>,
    /// Column of each motion: part, interface, axis.
    motions: Vec<Vec<[Option<usize>; 6]>>,
    count: usize,
}

fn columns(structure: &Structure) -> Columns {
    let mut count = 0;
    let mut next = |width: usize| {
        count += width;
        count - width
    };
    let mut nodes = Vec::new();
    let mut motions: Vec<Vec<[Option<usize>; 6]>> = Vec::new();
    for part in &structure.parts {
        let taken = |row: usize| part.interfaces.iter().any(|interface| interface.nodes().contains(&row));
        nodes.push((0..part.model.nodes.len()).map(|row| (!taken(row)).then(|| next(3))).collect());
        motions.push(part.interfaces.iter().map(|_| [Some(usize::MAX); 6]).collect());
    }
    let mut set = |motion: &Motion, column| motions[motion.part][motion.interface][motion.axis] = column;
    structure.held.iter().for_each(|motion| set(motion, None));
    let own = |motion: &Motion| {
        !structure.held.contains(motion) && structure.shared.iter().all(|pair| pair.1 != *motion)
    };
    for (number, part) in structure.parts.iter().enumerate() {
        for interface in 0..part.interfaces.len() {
            for motion in Structure::motions(number, interface, &[0, 1, 2, 3, 4, 5]).iter().filter(|m| own(m))
            {
                set(motion, Some(next(1)));
            }
        }
    }
    for (first, second) in &structure.shared {
        motions[second.part][second.interface][second.axis] =
            motions[first.part][first.interface][first.axis];
    }
    Columns { nodes, motions, count }
}

/// TᵀKT and TᵀMT, with springs and masses.
fn assemble(structure: &Structure) -> (SparseMatrix, SparseMatrix) {
    let columns = columns(structure);
    let (mut stiffness, mut mass) = (Vec::new(), Vec::new());
    for (number, part) in structure.parts.iter().enumerate() {
        // u of each degree of freedom as columns and factors
        let mut rows: Vec<Vec<(usize, f64)>> = vec![Vec::new(); 3 * part.model.nodes.len()];
        for (node, first) in columns.nodes[number].iter().enumerate() {
            for axis in 0..3 {
                rows[3 * node + axis].extend(first.map(|first| (first + axis, 1.0)));
            }
        }
        for (interface, motion) in part.interfaces.iter().zip(&columns.motions[number]) {
            for &node in interface.nodes() {
                let at = part.model.nodes.positions[node];
                let arm: Vec<f64> = (0..3).map(|i| at[i] - interface.reference_point()[i]).collect();
                // v + ω × arm
                for axis in 0..3 {
                    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                    let terms =
                        [(motion[axis], 1.0), (motion[3 + next], arm[last]), (motion[3 + last], -arm[next])];
                    rows[3 * node + axis]
                        .extend(terms.iter().filter_map(|&(column, factor)| Some((column?, factor))));
                }
            }
        }
        let add = |target: &mut Vec<Triplet<usize, usize, f64>>, i: usize, j: usize, value: f64| {
            for &(row, left) in &rows[i] {
                for &(column, right) in &rows[j] {
                    target.push(Triplet::new(row, column, left * value * right));
                }
            }
        };
        for entry in part.model.stiffness.as_ref().unwrap().triplet_iter() {
            add(&mut stiffness, entry.row, entry.col, *entry.val);
        }
        for entry in part.model.mass.triplet_iter() {
            for axis in 0..3 {
                add(&mut mass, 3 * entry.row + axis, 3 * entry.col + axis, *entry.val);
            }
        }
    }
    for (target, list) in [(&mut stiffness, &structure.springs), (&mut mass, &structure.masses)] {
        for (motion, value) in list {
            let column = columns.motions[motion.part][motion.interface][motion.axis].unwrap();
            target.push(Triplet::new(column, column, *value));
        }
    }
    let matrix = |list: &[Triplet<usize, usize, f64>]| {
        SparseColMat::try_new_from_triplets(columns.count, columns.count, list).unwrap()
    };
    (matrix(&stiffness), matrix(&mass))
}
