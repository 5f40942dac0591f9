//! What can go wrong between a mode basis and a reduced body.

/// What can go wrong between a mode basis and a reduced body.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReductionError {
    /// The basis describes another number of modes than it has shapes.
    #[error("mode basis: {shapes} shapes, but {modes} mode descriptions")]
    ModeCount {
        /// Columns of Ψ.
        shapes: usize,
        /// Entries of the mode list.
        modes: usize,
    },
    /// Neither a stiffness matrix nor a modal stiffness.
    #[error("the model has no stiffness matrix: a modal stiffness K_ff is needed")]
    MissingStiffness,
    /// A modal stiffness of a wrong size.
    #[error("modal stiffness: expected {modes} x {modes}, found {rows} x {columns}")]
    ModalStiffnessSize {
        /// Number of modes M.
        modes: usize,
        /// Rows found.
        rows: usize,
        /// Columns found.
        columns: usize,
    },
    /// A modal stiffness that is not symmetric.
    #[error(
        "modal stiffness is not symmetric: entry ({row}, {column}) is {value:e}, entry ({column}, {row}) is \
         {mirrored:e} (from 0); tolerated {tolerance:e} of the largest entry"
    )]
    ModalStiffnessAsymmetric {
        /// Row from 0.
        row: usize,
        /// Column from 0.
        column: usize,
        /// Value there.
        value: f64,
        /// Value of the mirrored entry.
        mirrored: f64,
        /// Largest difference accepted, relative to the largest entry.
        tolerance: f64,
    },
    /// A number that is not finite.
    #[error("{what}: expected finite numbers, found {value}")]
    NotFinite {
        /// Which input.
        what: String,
        /// The number.
        value: f64,
    },
    /// Bands of damping that do not cover all frequencies.
    #[error("damping bands: expected ascending frequencies above 0, the last inf, found {found:?}")]
    DampingBands {
        /// Where the bands end.
        found: String,
    },
    /// A wrong number of damping ratios.
    #[error("damping ratios: expected one for all or one for each of {modes} modes, found {found}")]
    DampingCount {
        /// Number of modes M.
        modes: usize,
        /// Ratios given.
        found: usize,
    },
    /// A negative damping coefficient.
    #[error("damping {what}: expected a finite value of at least 0, found {value}")]
    NegativeDamping {
        /// Which coefficient.
        what: String,
        /// Its value.
        value: f64,
    },
    /// A marker without nodes.
    #[error("marker `{marker}`: expected at least one node, got 0")]
    EmptyMarker {
        /// Name of the marker.
        marker: String,
    },
    /// A marker at a row beyond the node table.
    #[error("marker `{marker}`: node row {row} does not exist, the model has {nodes} nodes (rows from 0)")]
    MarkerNode {
        /// Name of the marker.
        marker: String,
        /// The row asked for.
        row: usize,
        /// Number of nodes N.
        nodes: usize,
    },
    /// The rotation of a marker cannot be told from its nodes.
    #[error(
        "marker `{marker}`: its rotation needs at least 3 nodes off one line, but the {nodes} nodes spread by only \
         {spread:e} across their line, relative to their extent"
    )]
    MarkerRotation {
        /// Name of the marker.
        marker: String,
        /// Number of nodes fitted.
        nodes: usize,
        /// Square root of the smallest over the largest eigenvalue of the fit.
        spread: f64,
    },
    /// A marker at a node that no matrix and no mode shape knows.
    #[error("marker `{marker}`: node {node} has neither mass nor stiffness: its motion is not defined")]
    MarkerLoose {
        /// Name of the marker.
        marker: String,
        /// Id of the node.
        node: u64,
    },
}
