//! Whether the stiffness knows the rotations of the node table as free of force: if not, which node is off.

use std::path::Path;

use crate::import::Note;
use crate::tolerances::{ROTATION_FORCE, TRANSLATION_FORCE};
use crate::{Nodes, SparseMatrix};

/// A node and how far it is from where the stiffness wants it.
#[derive(Debug, Clone, Copy)]
struct Misplaced {
    node: usize,
    offset: [f64; 3],
}

/// Warns of a stiffness that resists rotation at nodes where it does not resist translation.
///
/// If node n is off by δ, a rotation e moves it by e × δ too much, and the force on it is K_nn (e × δ). So δ follows
/// from the forces of the three rotations; at other nodes the same formula gives less.
pub(super) fn compare(nodes: &Nodes, stiffness: &SparseMatrix, path: &Path, notes: &mut Vec<Note>) {
    let count = nodes.len();
    let centre: [f64; 3] =
        std::array::from_fn(|i| nodes.positions.iter().map(|x| x[i]).sum::<f64>() / count as f64);
    let mut silent = vec![false; 3 * count];
    for axis in 0..3 {
        let motion: Vec<f64> = (0..3 * count).map(|dof| if dof % 3 == axis { 1.0 } else { 0.0 }).collect();
        let (force, scale) = product(stiffness, &motion);
        for dof in 0..3 * count {
            silent[dof] |= force[dof].abs() > TRANSLATION_FORCE * scale[dof];
        }
    }
    let mut residual = 0.0_f64;
    let mut forces: Vec<Vec<f64>> = Vec::new();
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let arm = |node: usize, i: usize| nodes.positions[node][i] - centre[i];
        let motion: Vec<f64> = (0..3 * count)
            .map(|dof| match dof % 3 {
                i if i == u => -arm(dof / 3, v),
                i if i == v => arm(dof / 3, u),
                _ => 0.0,
            })
            .collect();
        let (mut force, scale) = product(stiffness, &motion);
        for (entry, _) in force.iter_mut().zip(&silent).filter(|(_, silent)| **silent) {
            *entry = 0.0;
        }
        let norm = |vector: &[f64]| vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        let size = norm(&scale);
        if size > 0.0 {
            residual = residual.max(norm(&force) / size);
        }
        forces.push(force);
    }
    // The comparison this way also passes over numbers that overflow.
    if residual > ROTATION_FORCE
        && let Some(Misplaced { node, offset }) = farthest(stiffness, &forces, count)
    {
        let [x, y, z] = offset;
        let text = format!(
            "turning the part as a rigid body needs force: {residual:.1e} of what its stiffness could, where 1e-14 is \
             usual. Node {} moves most, as if its position were off by ({x:.1e}, {y:.1e}, {z:.1e}). Does the node \
             table belong to this matrix, and has it all digits?",
            nodes.ids[node]
        );
        notes.push(Note::warning(text).about(path));
    }
}

/// K x and |K| |x|.
fn product(matrix: &SparseMatrix, x: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (mut sum, mut scale) = (vec![0.0; x.len()], vec![0.0; x.len()]);
    for (column, &factor) in x.iter().enumerate().filter(|&(_, &factor)| factor != 0.0) {
        for (row, &value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
            sum[row] += value * factor;
            scale[row] += (value * factor).abs();
        }
    }
    (sum, scale)
}

/// The node that is off by most.
fn farthest(stiffness: &SparseMatrix, forces: &[Vec<f64>], count: usize) -> Option<Misplaced> {
    let square = |offset: [f64; 3]| offset.iter().map(|entry| entry * entry).sum::<f64>();
    let candidates = (0..count).filter_map(|node| {
        let block: [[f64; 3]; 3] = std::array::from_fn(|i| {
            std::array::from_fn(|j| stiffness.get(3 * node + i, 3 * node + j).copied().unwrap_or(0.0))
        });
        let [Some(a), Some(b), Some(c)] = [0, 1, 2].map(|axis: usize| {
            let force = forces.get(axis)?.get(3 * node..3 * node + 3)?;
            solve(&block, [force[0], force[1], force[2]])
        }) else {
            return None;
        };
        // a = e_x × δ = (0, -δz, δy) and so on.
        let offset = [0.5 * (c[1] - b[2]), 0.5 * (a[2] - c[0]), 0.5 * (b[0] - a[1])];
        Some(Misplaced { node, offset }).filter(|found| square(found.offset).is_finite())
    });
    candidates.max_by(|a, b| square(a.offset).total_cmp(&square(b.offset)))
}

/// Solves a 3 x 3 system by cofactors; `None` if it is singular.
fn solve(a: &[[f64; 3]; 3], b: [f64; 3]) -> Option<[f64; 3]> {
    let cross = |u: [f64; 3], v: [f64; 3]| {
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    };
    let rows = [cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])];
    let determinant: f64 = (0..3).map(|i| a[0][i] * rows[0][i]).sum();
    if determinant == 0.0 || !determinant.is_finite() {
        return None;
    }
    // The rows of cofactors are the columns of the adjugate.
    Some(std::array::from_fn(|i| (0..3).map(|j| rows[j][i] * b[j]).sum::<f64>() / determinant))
}
