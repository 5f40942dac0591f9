//! Nodes with what their file says about matrices: labels, elements, boundary conditions.

use std::collections::BTreeMap;
use std::path::PathBuf;

use crate::import::ImportError;
use crate::import::text::source::Source;
use crate::{Element, Nodes, SolidMaterial};

/// What a node source supplies.
#[derive(Debug, Default)]
pub(crate) struct NodeTable {
    /// Ids, positions and sets.
    pub(crate) nodes: Nodes,
    /// Elements that can be drawn.
    pub(crate) elements: Vec<Element>,
    /// Where each element stands in the file, for messages; empty if that is not known.
    pub(crate) element_places: Vec<usize>,
    /// Numbers of the elements of each named group of elements, sorted.
    pub(crate) element_sets: BTreeMap<String, Vec<usize>>,
    /// Materials.
    pub(crate) materials: Vec<SolidMaterial>,
    /// Which nodes belong to some element; `None` if the file has no elements.
    pub(crate) attached: Option<Vec<bool>>,
    /// Element types known to make trouble, at their first line.
    pub(crate) troubles: Vec<ElementTrouble>,
    /// True if the file prescribes boundary conditions.
    pub(crate) has_boundary: bool,
}

/// An element type whose exported matrices are not what this program needs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct ElementTrouble {
    /// The element type, upper case.
    pub(crate) element: String,
    /// The file.
    pub(crate) path: PathBuf,
    /// Line number from 1.
    pub(crate) line: usize,
    /// What is wrong with it.
    pub(crate) kind: TroubleKind,
}

/// What is wrong with an element type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TroubleKind {
    /// Its matrices have rows of nodes that the deck does not know.
    InternalNodes,
    /// Its mass matrix is singular.
    SingularMass,
    /// Its nodes have rotations, or are expanded into nodes that the deck does not know.
    Rotations,
}

impl NodeTable {
    /// Refuses an empty table and one whose degrees of freedom do not fit 32 bits.
    pub(crate) fn check_size(self, source: &Source) -> Result<Self, ImportError> {
        if self.nodes.is_empty() {
            return Err(ImportError::NoNodes { path: source.path().to_path_buf() });
        }
        let limit = u32::MAX as usize / 3;
        if self.nodes.len() > limit {
            return Err(ImportError::SizeMismatch {
                path: source.path().to_path_buf(),
                expected: format!("at most {limit} nodes"),
                found: self.nodes.len(),
                what: "nodes",
            });
        }
        Ok(self)
    }

    /// Keeps the nodes with `keep[row]`; elements that lose a node are dropped.
    pub(crate) fn retain(&mut self, keep: &[bool]) {
        let map = compressed(keep);
        let row = |old: usize| map[old] as usize;
        let old = std::mem::take(&mut self.nodes);
        self.nodes = Nodes {
            ids: kept(&old.ids, keep),
            positions: kept(&old.positions, keep),
            sets: old
                .sets
                .into_iter()
                .map(|(name, rows)| (name, rows.into_iter().filter(|&old| keep[old]).map(row).collect()))
                .collect(),
        };
        let stays: Vec<bool> =
            self.elements.iter().map(|element| element.nodes.iter().all(|&old| keep[old])).collect();
        self.elements = kept(&self.elements, &stays);
        self.element_places = kept(&self.element_places, &stays);
        let new = compressed(&stays);
        for numbers in self.element_sets.values_mut() {
            numbers.retain(|&old| stays[old]);
            numbers.iter_mut().for_each(|number| *number = new[*number] as usize);
        }
        for node in self.elements.iter_mut().flat_map(|element| &mut element.nodes) {
            *node = row(*node);
        }
        self.attached = self.attached.as_ref().map(|attached| kept(attached, keep));
    }
}

/// New row of each kept row; rows that are not kept get a number without meaning.
pub(crate) fn compressed(keep: &[bool]) -> Vec<u32> {
    let mut next = 0;
    keep.iter()
        .map(|&kept| {
            let row = next;
            next += u32::from(kept);
            row
        })
        .collect()
}

fn kept<T: Clone>(values: &[T], keep: &[bool]) -> Vec<T> {
    values.iter().zip(keep).filter(|&(_, &keep)| keep).map(|(value, _)| value.clone()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dropping_a_node_renumbers_sets_and_elements() {
        let element = |nodes: Vec<usize>| Element { kind: crate::ElementKind::Tetrahedron4, nodes };
        let mut table = NodeTable {
            nodes: Nodes {
                ids: vec![1, 2, 3, 4, 5],
                positions: (0..5).map(|n| [f64::from(n), 0.0, 0.0]).collect(),
                sets: [("end".to_owned(), vec![1, 2, 4])].into(),
            },
            elements: vec![element(vec![0, 1, 2, 3]), element(vec![0, 2, 3, 4])],
            element_sets: [("all".to_owned(), vec![0, 1])].into(),
            ..NodeTable::default()
        };
        table.retain(&[true, false, true, true, true]);
        assert_eq!(table.nodes.ids, [1, 3, 4, 5]);
        assert_eq!(table.nodes.positions[1][0], 2.0);
        assert_eq!(table.nodes.sets["end"], [1, 3]);
        assert_eq!(table.elements, [element(vec![0, 1, 2, 3])]);
        assert_eq!(table.element_sets["all"], [0]);
    }
}
