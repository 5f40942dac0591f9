//! From parts and instances to one node table.

use std::collections::HashSet;

use super::mesh::{Mesh, Place};
use super::placed::{Placed, unknown};
use super::sets::sets;
use crate::import::ImportError;
use crate::import::nodes::{NodeLookup, NodeTable};
use crate::import::text::source::Source;
use crate::{Element, Nodes};

/// Puts all meshes into one table. Where labels of two instances clash, those of the later one are raised by the
/// largest label before.
pub(super) fn assemble(meshes: &[Mesh], sources: &[Source]) -> Result<NodeTable, ImportError> {
    let mut nodes = Nodes::default();
    let mut taken: HashSet<u64> = HashSet::new();
    let mut placed: Vec<Placed<'_>> = Vec::new();
    for mesh in meshes {
        let lookup = NodeLookup::new(&mesh.ids);
        let clash = mesh.ids.iter().any(|id| taken.contains(id));
        // A label 0 needs one more than the largest label before.
        let largest = nodes.ids.iter().copied().max().unwrap_or(0);
        let raise = if clash { largest.saturating_add(u64::from(mesh.ids.contains(&0))) } else { 0 };
        let mut rows = Vec::with_capacity(mesh.ids.len());
        for (local, &id) in mesh.ids.iter().enumerate() {
            // A table keeps the last of equal labels: an earlier one was given again.
            let last = lookup.row(id).unwrap_or(local);
            let Place { source, at } = mesh.places[last];
            let place = || (sources[source].path().to_path_buf(), sources[source].line_of(at));
            if last != local {
                if mesh.positions[last] != mesh.positions[local] {
                    let (path, line) = place();
                    return Err(ImportError::DuplicateNode { path, line, id });
                }
                rows.push(usize::MAX);
                continue;
            }
            let Some(raised) = id.checked_add(raise) else {
                let (path, line) = place();
                return Err(ImportError::LabelOverflow { path, line, id, raise });
            };
            rows.push(nodes.ids.len());
            nodes.ids.push(raised);
            nodes.positions.push(mesh.placement.apply(mesh.positions[local]));
        }
        let new = nodes.ids.len() - rows.iter().filter(|&&row| row != usize::MAX).count();
        taken.extend(&nodes.ids[new..]);
        let mut labels = mesh.ids.clone();
        labels.sort_unstable();
        labels.dedup();
        placed.push(Placed { mesh, labels, rows, lookup });
    }
    let elements = elements(&placed, sources, nodes.len())?;
    nodes.sets = sets(&placed, sources)?;
    let attached = meshes.iter().any(|mesh| !mesh.elements.is_empty()).then_some(elements.attached);
    Ok(NodeTable { nodes, elements: elements.drawable, attached, ..NodeTable::default() })
}

struct Elements {
    drawable: Vec<Element>,
    attached: Vec<bool>,
}

fn elements(placed: &[Placed<'_>], sources: &[Source], nodes: usize) -> Result<Elements, ImportError> {
    let mut drawable = Vec::new();
    let mut attached = vec![false; nodes];
    for part in placed {
        for element in &part.mesh.elements {
            let mut rows = Vec::with_capacity(element.nodes.len());
            for &label in &element.nodes {
                match part.row(label) {
                    Some(row) => rows.push(row),
                    // Elements of other kinds may hold numbers that are no nodes.
                    None if element.kind.is_none() => {}
                    None => return Err(unknown(sources, element.place, label, part)),
                }
            }
            for &row in &rows {
                attached[row] = true;
            }
            drawable.extend(element.kind.map(|kind| Element { kind, nodes: rows }));
        }
    }
    Ok(Elements { drawable, attached })
}
