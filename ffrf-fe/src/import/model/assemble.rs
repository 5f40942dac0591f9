//! Puts node table, mass and stiffness together: sizes, boundary conditions, symmetry, isotropy, definiteness.

use std::path::Path;

use crate::import::matrix::definiteness::refuse_indefinite;
use crate::import::matrix::raw_matrix::{Numbering, RawMatrix};
use crate::import::matrix::scalar_mass::{ScalarMass, scalar_mass};
use crate::import::matrix::sparse_lines::SparseLines;
use crate::import::nodes::{NodeTable, compressed};
use crate::{FeError, SparseMatrix};

/// Abaqus writes 1e36 on the diagonal of degrees of freedom that boundary conditions hold.
const HELD_DIAGONAL: f64 = 1e35;

/// The checked parts of a model.
pub(crate) struct Assembled {
    pub(crate) mass: ScalarMass,
    pub(crate) stiffness: Option<SparseMatrix>,
    pub(crate) fixed_dofs: Vec<usize>,
}

/// A matrix over all degrees of freedom, and which of them were held.
struct Settled {
    lines: SparseLines,
    /// Held by a huge diagonal entry, or left out of a list.
    held: Vec<bool>,
    /// Held by a huge diagonal entry.
    huge: Vec<bool>,
}

pub(crate) fn assemble(
    table: &NodeTable,
    mass: &mut RawMatrix,
    stiffness: Option<&mut RawMatrix>,
) -> Result<Assembled, FeError> {
    let nodes = table.nodes.len();
    let dofs = 3 * nodes;
    let mut held = vec![false; dofs];
    let stiffness = match stiffness {
        None => None,
        Some(raw) => {
            refuse_size(raw, nodes, false)?;
            let settled = settle(raw);
            held.copy_from_slice(&settled.held);
            let matrix = settled.lines.symmetric(raw.storage, raw.source.path())?;
            refuse_indefinite(&matrix, "stiffness", raw.source.path())?;
            Some(matrix)
        }
    };
    refuse_size(mass, nodes, true)?;
    let path = &mass.source.path().to_path_buf();
    let scalar = if mass.size == nodes {
        let matrix = SparseLines::from_entries(std::mem::take(&mut mass.entries), nodes)
            .symmetric(mass.storage, path)?;
        ScalarMass { matrix, anisotropy: 0.0 }
    } else {
        let settled = settle(mass);
        if stiffness.is_none() {
            // Without stiffness a node that the list leaves out whole has no mass; one left out in part is held.
            for (flags, missing) in held.chunks_exact_mut(3).zip(settled.held.chunks_exact(3)) {
                if missing != [true; 3] {
                    flags.copy_from_slice(missing);
                }
            }
        }
        let known: Vec<bool> = (0..dofs)
            .map(|dof| {
                let has_mass = settled.lines.diagonal(dof).is_some_and(|value| value != 0.0);
                !settled.huge[dof] && (!held[dof] || has_mass)
            })
            .collect();
        for (flag, huge) in held.iter_mut().zip(&settled.huge) {
            *flag |= huge;
        }
        let full = settled.lines.symmetric(mass.storage, path)?;
        scalar_mass(&full, &known, table, path)?
    };
    refuse_massless(&scalar.matrix, path)?;
    refuse_indefinite(&scalar.matrix, "mass", path)?;
    let fixed_dofs = (0..dofs).filter(|&dof| held[dof]).collect();
    Ok(Assembled { mass: scalar, stiffness, fixed_dofs })
}

/// Takes the entries, sorts them and finds the held degrees of freedom; their rows become zero.
fn settle(raw: &mut RawMatrix) -> Settled {
    let present = match raw.numbering {
        Numbering::Declared => vec![true; raw.size],
        Numbering::Listed | Numbering::Labelled => raw.entries.present(raw.size),
    };
    let mut lines = SparseLines::from_entries(std::mem::take(&mut raw.entries), raw.size);
    let huge: Vec<bool> =
        (0..raw.size).map(|dof| lines.diagonal(dof).is_some_and(|value| value >= HELD_DIAGONAL)).collect();
    lines.clear(&huge);
    let held = present.iter().zip(&huge).map(|(&present, &huge)| huge || !present).collect();
    Settled { lines, held, huge }
}

fn refuse_size(raw: &RawMatrix, nodes: usize, scalar_allowed: bool) -> Result<(), FeError> {
    if raw.size == 3 * nodes || (scalar_allowed && raw.size == nodes) {
        return Ok(());
    }
    let scalar = if scalar_allowed { format!(" or {nodes} (one direction)") } else { String::new() };
    Err(FeError::SizeMismatch {
        path: raw.source.path().to_path_buf(),
        expected: format!("{} rows (x, y, z of {nodes} nodes){scalar}", 3 * nodes),
        found: raw.size,
        what: "rows",
    })
}

fn refuse_massless(mass: &SparseMatrix, path: &Path) -> Result<(), FeError> {
    let total: f64 = mass.val().iter().sum();
    if total > 0.0 {
        return Ok(());
    }
    Err(FeError::NoMass { path: path.to_path_buf(), total })
}

/// Drops nodes that no matrix knows: points without elements, or outside the set that was exported.
///
/// `unlisted_is_held` says that a node of an element which the matrices leave out was held (CalculiX).
pub(crate) fn drop_unused_nodes(
    table: &mut NodeTable,
    mass: &mut RawMatrix,
    stiffness: Option<&mut RawMatrix>,
    unlisted_is_held: bool,
) {
    let nodes = table.nodes.len();
    let mut matrices: Vec<&mut RawMatrix> = std::iter::once(mass).chain(stiffness).collect();
    let labelled: Vec<&RawMatrix> =
        matrices.iter().filter(|raw| raw.numbering == Numbering::Labelled).map(|raw| &**raw).collect();
    let keep: Vec<bool> = if labelled.is_empty() {
        let Some(attached) = &table.attached else { return };
        let dofs = 3 * attached.iter().filter(|&&attached| attached).count();
        // Numbered rows count the nodes of elements only; with other sizes nothing can be said.
        if dofs == 3 * nodes || matrices.iter().any(|raw| raw.size != dofs && 3 * raw.size != dofs) {
            return;
        }
        attached.clone()
    } else {
        let mut listed = vec![false; nodes];
        for raw in labelled {
            for (node, present) in raw.entries.present(3 * nodes).chunks_exact(3).enumerate() {
                listed[node] |= present.contains(&true);
            }
        }
        let held = |node: usize| {
            let attached = table.attached.as_ref().map(|attached| attached[node]);
            attached.unwrap_or(table.has_boundary) && (table.has_boundary || unlisted_is_held)
        };
        (0..nodes).map(|node| listed[node] || held(node)).collect()
    };
    let map = compressed(&keep);
    let dof_map: Vec<u32> = map.iter().flat_map(|&row| [3 * row, 3 * row + 1, 3 * row + 2]).collect();
    let kept = keep.iter().filter(|&&keep| keep).count();
    for raw in matrices.iter_mut().filter(|raw| raw.numbering == Numbering::Labelled) {
        raw.entries.renumber(&dof_map);
        raw.size = 3 * kept;
    }
    if kept < nodes {
        table.retain(&keep);
    }
}
