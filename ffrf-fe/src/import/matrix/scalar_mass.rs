//! From the mass matrix of all directions to the scalar one: M_FE = M_s ⊗ I3.

use std::path::Path;

use super::symmetric::sparse;
use crate::SparseMatrix;
use crate::import::ImportError;
use crate::import::nodes::NodeTable;
use crate::tolerances::ISOTROPY_TOLERANCE;

/// The scalar mass matrix and what was lost by taking it.
pub(crate) struct ScalarMass {
    /// M_s. Shape: N x N, both triangles. Units: kg.
    pub(crate) matrix: SparseMatrix,
    /// Largest deviation of M_FE from M_s ⊗ I3 over the largest entry.
    pub(crate) anisotropy: f64,
}

/// Takes M_s from a 3N x 3N matrix. `known[dof]` is false where boundary conditions removed the mass of a degree
/// of freedom; the other directions of the node then stand for it.
///
/// Source: `docs/theory/equations.md`, (206-208), which hold for M_FE = M_s ⊗ I3 only.
pub(crate) fn scalar_mass(
    full: &SparseMatrix,
    known: &[bool],
    table: &NodeTable,
    path: &Path,
) -> Result<ScalarMass, ImportError> {
    let nodes = table.nodes.len();
    let masks: Vec<[bool; 3]> = known.chunks_exact(3).map(|of| [of[0], of[1], of[2]]).collect();
    refuse_unknown_mass(&masks, table, path)?;
    let largest = full.val().iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let mut worst = (0.0_f64, 0, 0);
    let mut note = |deviation: f64, row: usize, column: usize| {
        if deviation > worst.0 {
            worst = (deviation, row, column);
        }
    };
    let mut direct = vec![[0.0_f64; 3]; nodes];
    let mut touched: Vec<usize> = Vec::new();
    let mut is_touched = vec![false; nodes];
    let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
    for node in 0..nodes {
        for direction in 0..3 {
            let column = 3 * node + direction;
            for (row, &value) in full.row_idx_of_col(column).zip(full.val_of_col(column)) {
                let other = row / 3;
                if row % 3 == direction {
                    direct[other][direction] = value;
                } else {
                    note(value.abs(), row, column);
                }
                if !is_touched[other] {
                    is_touched[other] = true;
                    touched.push(other);
                }
            }
        }
        touched.sort_unstable();
        for &other in &touched {
            let block = direct[other];
            let usable = |direction: &usize| masks[node][*direction] && masks[other][*direction];
            // The mean of the directions, taken as first + mean difference so that equal entries stay exact.
            let first = (0..3).find(usable).map_or(0.0, |direction| block[direction]);
            let count = (0..3).filter(usable).count().max(1) as f64;
            let mean =
                first + (0..3).filter(usable).map(|direction| block[direction] - first).sum::<f64>() / count;
            for direction in (0..3).filter(usable) {
                note((block[direction] - mean).abs(), 3 * other + direction, 3 * node + direction);
            }
            if mean != 0.0 || other == node {
                rows.push(other);
                values.push(mean);
            }
            direct[other] = [0.0; 3];
            is_touched[other] = false;
        }
        touched.clear();
        starts.push(rows.len());
    }
    let (deviation, row, column) = worst;
    let anisotropy = if largest > 0.0 { deviation / largest } else { 0.0 };
    if anisotropy > ISOTROPY_TOLERANCE {
        return Err(ImportError::Anisotropic {
            path: path.to_path_buf(),
            row: row + 1,
            column: column + 1,
            deviation: anisotropy,
            tolerance: ISOTROPY_TOLERANCE,
        });
    }
    Ok(ScalarMass { matrix: sparse(nodes, starts, rows, values), anisotropy })
}

/// Refuses nodes whose mass no direction shows, and neighbours that have no direction in common.
fn refuse_unknown_mass(masks: &[[bool; 3]], table: &NodeTable, path: &Path) -> Result<(), ImportError> {
    let mut hidden: Vec<usize> = (0..masks.len()).filter(|&node| masks[node] == [false; 3]).collect();
    if hidden.is_empty() {
        let disjoint = |a: usize, b: usize| (0..3).all(|i| !(masks[a][i] && masks[b][i]));
        if table.elements.is_empty() {
            // Without elements any two nodes may be neighbours: compare one node of each pattern.
            let mut examples: Vec<usize> = Vec::new();
            for node in 0..masks.len() {
                if examples.iter().all(|&example| masks[example] != masks[node]) {
                    examples.push(node);
                }
            }
            for (place, &a) in examples.iter().enumerate() {
                hidden.extend(examples[..place].iter().filter(|&&b| disjoint(a, b)).flat_map(|&b| [b, a]));
            }
        } else {
            for element in &table.elements {
                for (place, &a) in element.nodes.iter().enumerate() {
                    let others = element.nodes[..place].iter();
                    hidden.extend(others.filter(|&&b| disjoint(a, b)).flat_map(|&b| [b, a]));
                }
            }
        }
        hidden.sort_unstable();
        hidden.dedup();
    }
    match hidden.first() {
        None => Ok(()),
        Some(&first) => Err(ImportError::MassUnknown {
            path: path.to_path_buf(),
            nodes: hidden.len(),
            first: table.nodes.ids[first],
        }),
    }
}
