//! Nodes that no matrix knows: points without elements, or outside the set that was exported.

use crate::import::Note;
use crate::import::matrix::raw_matrix::RawMatrix;
use crate::import::nodes::{NodeTable, compressed};

use super::coverage::listed;

/// Drops nodes that no matrix knows, and says so.
///
/// `unlisted_is_held` says that a node of an element which the matrices leave out was held (CalculiX).
pub(crate) fn drop_unused_nodes(
    table: &mut NodeTable,
    mass: &mut RawMatrix,
    stiffness: Option<&mut RawMatrix>,
    unlisted_is_held: bool,
    notes: &mut Vec<Note>,
) {
    let nodes = table.nodes.len();
    let mut matrices: Vec<&mut RawMatrix> = std::iter::once(mass).chain(stiffness).collect();
    let labelled: Vec<&RawMatrix> =
        matrices.iter().filter(|raw| raw.numbering.is_labelled()).map(|raw| &**raw).collect();
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
    for raw in matrices.iter_mut().filter(|raw| raw.numbering.is_labelled()) {
        raw.entries.renumber(&dof_map);
        raw.size = 3 * kept;
    }
    if kept < nodes {
        let dropped = (0..nodes).filter(|&node| !keep[node]).map(|node| table.nodes.ids[node]);
        let what = if nodes - kept == 1 { "node is" } else { "nodes are" };
        let text = format!("{} {what} in no matrix and left out ({})", nodes - kept, listed(dropped));
        notes.push(Note::reading(text));
        table.retain(&keep);
    }
}
