//! What can go wrong with stress recovery.

/// What can go wrong with stress recovery.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum StressError {
    /// No node is named.
    #[error("stress marker {marker}: expected at least one node")]
    Empty {
        /// Name of the marker.
        marker: String,
    },
    /// A row beyond the node table.
    #[error("stress marker {marker}: node row {row} does not exist, there are {nodes} nodes (rows from 0)")]
    UnknownNode {
        /// Name of the marker.
        marker: String,
        /// The row.
        row: usize,
        /// Number of nodes N.
        nodes: usize,
    },
    /// A node without stress.
    #[error(
        "stress marker {marker}: node {node} belongs to no solid element that is known here: give a mesh, or the deck \
         with --abaqus, --calculix or --nastran"
    )]
    NoElement {
        /// Name of the marker.
        marker: String,
        /// Id of the node.
        node: u64,
    },
}
