//! Nodes with what their file says about matrices: labels, elements, boundary conditions.

use std::collections::HashMap;

use super::source::Source;
use crate::{Element, FeError, Nodes};

/// What a node source supplies.
#[derive(Debug, Default)]
pub(crate) struct NodeTable {
    /// Ids, positions and sets.
    pub(crate) nodes: Nodes,
    /// Elements that can be drawn.
    pub(crate) elements: Vec<Element>,
    /// Which nodes belong to some element; `None` if the file has no elements.
    pub(crate) attached: Option<Vec<bool>>,
    /// True if the file prescribes boundary conditions.
    pub(crate) has_boundary: bool,
}

impl NodeTable {
    /// Refuses an empty table and one whose degrees of freedom do not fit 32 bits.
    pub(crate) fn check_size(self, source: &Source) -> Result<Self, FeError> {
        if self.nodes.is_empty() {
            return Err(FeError::NoNodes { path: source.path().to_path_buf() });
        }
        let limit = u32::MAX as usize / 3;
        if self.nodes.len() > limit {
            return Err(FeError::SizeMismatch {
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
        self.elements.retain(|element| element.nodes.iter().all(|&old| keep[old]));
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

/// Finds rows of the node table by label.
#[derive(Debug)]
pub(crate) enum NodeLookup {
    /// Labels are small: a table by label with row + 1, 0 for none.
    Table { rows: Vec<u32>, nodes: usize },
    /// Labels are scattered.
    Map(HashMap<u64, usize>),
}

impl NodeLookup {
    pub(crate) fn new(ids: &[u64]) -> Self {
        let largest = ids.iter().copied().max().unwrap_or(0);
        // Up to four empty places per node a table is smaller and faster than a map.
        match usize::try_from(largest) {
            Ok(largest) if largest <= 5 * ids.len() + 1000 => {
                let mut rows = vec![0_u32; largest + 1];
                for (row, &id) in ids.iter().enumerate() {
                    rows[id as usize] = row as u32 + 1;
                }
                NodeLookup::Table { rows, nodes: ids.len() }
            }
            _ => NodeLookup::Map(ids.iter().enumerate().map(|(row, &id)| (id, row)).collect()),
        }
    }

    /// Row of a label.
    #[inline]
    pub(crate) fn row(&self, label: u64) -> Option<usize> {
        match self {
            NodeLookup::Table { rows, .. } => {
                let row = *rows.get(usize::try_from(label).ok()?)?;
                row.checked_sub(1).map(|row| row as usize)
            }
            NodeLookup::Map(rows) => rows.get(&label).copied(),
        }
    }

    /// Number of nodes.
    pub(crate) fn len(&self) -> usize {
        match self {
            NodeLookup::Table { nodes, .. } => *nodes,
            NodeLookup::Map(rows) => rows.len(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lookup_by_table_and_by_map() {
        for ids in [vec![3, 1, 7], vec![3_000_000_000, 1, 7]] {
            let lookup = NodeLookup::new(&ids);
            assert_eq!(lookup.len(), 3);
            assert_eq!(lookup.row(ids[0]), Some(0));
            assert_eq!(lookup.row(7), Some(2));
            assert_eq!(lookup.row(2), None);
            assert_eq!(lookup.row(u64::MAX), None);
        }
    }

    #[test]
    fn dropping_a_node_renumbers_sets_and_elements() {
        let element = |nodes: Vec<usize>| Element { kind: crate::ElementKind::Tetrahedron4, nodes };
        let mut table = NodeTable {
            nodes: Nodes {
                ids: vec![1, 2, 3, 4, 5],
                positions: (0..5).map(|n| [f64::from(n), 0.0, 0.0]).collect(),
                sets: [("end".to_owned(), vec![1, 2, 4])].into(),
            },
            elements: vec![element(vec![0, 2, 3, 4]), element(vec![0, 1, 2, 3])],
            ..NodeTable::default()
        };
        table.retain(&[true, false, true, true, true]);
        assert_eq!(table.nodes.ids, [1, 3, 4, 5]);
        assert_eq!(table.nodes.positions[1][0], 2.0);
        assert_eq!(table.nodes.sets["end"], [1, 3]);
        assert_eq!(table.elements, [element(vec![0, 1, 2, 3])]);
    }
}
