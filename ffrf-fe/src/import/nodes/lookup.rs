//! Rows of the node table by label.

use std::collections::HashMap;

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
}
