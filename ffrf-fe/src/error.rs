//! The error type of this crate.

use std::path::PathBuf;

/// What can go wrong between a finite-element export and a reduced body.
///
/// Rows, columns and lines in messages count from 1, as in the files.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FeError {
    /// A file cannot be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// A line of a file is not what its format asks for, such as `1 2 abc` for `row column value`.
    #[error("{}:{line}: expected {expected}, found {found}", path.display())]
    Parse {
        /// The file.
        path: PathBuf,
        /// Line number from 1.
        line: usize,
        /// What should stand there.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// A number is `nan` or `inf`.
    #[error("{}:{line}: expected a finite number, found {found}", path.display())]
    NonFinite {
        /// The file.
        path: PathBuf,
        /// Line number from 1; in a binary array the position of the value, from 1.
        line: usize,
        /// The number as it stands there.
        found: String,
    },
    /// A binary array (`.npy`, `.npz`) is not what is asked for.
    #[error("{}: array `{array}`: expected {expected}, found {found}", path.display())]
    Array {
        /// The file.
        path: PathBuf,
        /// Name of the array; empty in a `.npy` file.
        array: String,
        /// What should stand there.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// A file ends before all that it announces, such as a header `3 3 4` before three entries.
    #[error("{}:{line}: the file is cut off: expected {expected} {what}, found {found}", path.display())]
    Truncated {
        /// The file.
        path: PathBuf,
        /// Last line, from 1.
        line: usize,
        /// What is counted.
        what: &'static str,
        /// Number announced.
        expected: usize,
        /// Number present.
        found: usize,
    },
    /// A feature of the file's language changes the nodes or matrices and is not read.
    #[error("{}:{line}: {feature} is not supported here: {advice}", path.display())]
    Unsupported {
        /// The file.
        path: PathBuf,
        /// Line number from 1.
        line: usize,
        /// The keyword or option.
        feature: String,
        /// What to do instead.
        advice: &'static str,
    },
    /// The same node id is given twice with different positions.
    #[error("{}:{line}: node {id} is given a second time, at another position", path.display())]
    DuplicateNode {
        /// The file.
        path: PathBuf,
        /// Line of the second definition, from 1.
        line: usize,
        /// The node id.
        id: u64,
    },
    /// A node id is not in the node table.
    #[error("{}:{line}: expected a node of the node table ({nodes} nodes), found node {id}", path.display())]
    UnknownNode {
        /// The file.
        path: PathBuf,
        /// Line number from 1.
        line: usize,
        /// The node id.
        id: u64,
        /// Number of nodes N.
        nodes: usize,
    },
    /// A node file without a node.
    #[error("{}: expected nodes, found none", path.display())]
    NoNodes {
        /// The file.
        path: PathBuf,
    },
    /// A file that the import needs is not named.
    #[error("the {role} file is missing: {advice}")]
    MissingFile {
        /// What the file would supply.
        role: &'static str,
        /// How to name it.
        advice: String,
    },
    /// A matrix has not as many rows as columns.
    #[error("{}: expected a square matrix, found {rows} rows and {columns} columns", path.display())]
    NotSquare {
        /// The file.
        path: PathBuf,
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
    /// Two inputs do not fit together in size.
    #[error("{}: expected {expected}, found {found} {what}", path.display())]
    SizeMismatch {
        /// The file.
        path: PathBuf,
        /// The size asked for, with its reason.
        expected: String,
        /// The size found.
        found: usize,
        /// What is counted.
        what: &'static str,
    },
    /// A matrix that must be symmetric is not.
    #[error(
        "{}: not symmetric: entry ({row}, {column}) is {value:e}, entry ({column}, {row}) is {mirrored:e}; \
         deviation {deviation:.3e} of the largest entry, tolerated {tolerance:e}",
        path.display()
    )]
    Asymmetric {
        /// The file.
        path: PathBuf,
        /// Row of the worst entry, from 1.
        row: usize,
        /// Its column, from 1.
        column: usize,
        /// Its value.
        value: f64,
        /// Value of the mirrored entry (0 if not stored).
        mirrored: f64,
        /// Difference over the largest entry of the matrix.
        deviation: f64,
        /// Largest deviation tolerated.
        tolerance: f64,
    },
    /// The mass matrix is not M_s ⊗ I3: its directions differ or are coupled.
    #[error(
        "{}: mass is not the same in x, y and z (M_FE is not M_s x I3): entry ({row}, {column}) deviates by \
         {deviation:.3e} of the largest entry, tolerated {tolerance:e}",
        path.display()
    )]
    Anisotropic {
        /// The file.
        path: PathBuf,
        /// Row of the worst entry, from 1.
        row: usize,
        /// Its column, from 1.
        column: usize,
        /// Deviation over the largest entry of the matrix.
        deviation: f64,
        /// Largest deviation tolerated.
        tolerance: f64,
    },
    /// A matrix that must be positive semidefinite has negative eigenvalues.
    #[error(
        "{}: the {role} matrix is indefinite: {negative} of {size} pivots are negative, the worst is {pivot:.3e} \
         times its diagonal entry (row {row}), tolerated -{tolerance:e}",
        path.display()
    )]
    Indefinite {
        /// The file.
        path: PathBuf,
        /// `mass` or `stiffness`.
        role: &'static str,
        /// Number of negative pivots of the scaled factorisation, the number of negative eigenvalues.
        negative: usize,
        /// Size of the matrix.
        size: usize,
        /// Row of the most negative pivot, from 1.
        row: usize,
        /// The most negative pivot over the diagonal entry.
        pivot: f64,
        /// Largest negative value tolerated, relative to the diagonal.
        tolerance: f64,
    },
    /// The factorisation that decides definiteness broke down.
    #[error("{}: the {role} matrix of {size} rows cannot be factorised: {reason}", path.display())]
    Factorization {
        /// The file.
        path: PathBuf,
        /// `mass` or `stiffness`.
        role: &'static str,
        /// Size of the matrix.
        size: usize,
        /// What the factorisation reports.
        reason: String,
    },
    /// The total mass is not positive.
    #[error("{}: expected a positive total mass, found {total:e} kg", path.display())]
    NoMass {
        /// The file.
        path: PathBuf,
        /// Sum of all entries of M_s. Units: kg.
        total: f64,
    },
    /// The export left out mass that no other direction of the node shows.
    #[error(
        "{}: the mass of {nodes} nodes (first: node {first}) is not in the file because boundary conditions \
         hold all directions that would show it; export the matrices without boundary conditions and clamp \
         the node set when computing the modes",
        path.display()
    )]
    MassUnknown {
        /// The file.
        path: PathBuf,
        /// Number of nodes concerned.
        nodes: usize,
        /// Id of the first of them.
        first: u64,
    },
    /// The modes cannot be computed.
    #[error(transparent)]
    Modes(#[from] crate::modes::ModeError),
    /// The body cannot be reduced.
    #[error(transparent)]
    Reduction(#[from] crate::reduction::ReductionError),
    /// The reduced body contradicts itself.
    #[error(transparent)]
    Model(#[from] ffrf_model::ModelError),
    /// An element is not usable.
    #[error(transparent)]
    Element(#[from] crate::elements::ElementError),
}
