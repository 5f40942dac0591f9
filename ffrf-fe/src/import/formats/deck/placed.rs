//! Where the nodes of a part or an instance stand in the whole table.

use super::mesh::{Mesh, Place};
use crate::import::ImportError;
use crate::import::nodes::NodeLookup;
use crate::import::text::source::Source;

/// Where the nodes of one mesh went.
pub(super) struct Placed<'a> {
    pub(super) mesh: &'a Mesh,
    /// Labels of the mesh, ascending, each once.
    pub(super) labels: Vec<u64>,
    /// Row in the whole table of each node of the mesh.
    pub(super) rows: Vec<usize>,
    pub(super) lookup: NodeLookup,
}

impl Placed<'_> {
    /// Row in the whole table of a label of the mesh.
    pub(super) fn row(&self, label: u64) -> Option<usize> {
        self.lookup.row(label).map(|local| self.rows[local])
    }

    /// Where the labels from `first` to `last` stand among [`Self::labels`].
    pub(super) fn labels_between(&self, first: u64, last: u64) -> (usize, usize) {
        let from = self.labels.partition_point(|&label| label < first);
        (from, self.labels.partition_point(|&label| label <= last))
    }
}

/// A label that no node of its part has.
pub(super) fn unknown(sources: &[Source], place: Place, id: u64, part: &Placed<'_>) -> ImportError {
    let source = &sources[place.source];
    ImportError::UnknownNode {
        path: source.path().to_path_buf(),
        line: source.line_of(place.at),
        id,
        nodes: part.mesh.ids.len(),
    }
}
