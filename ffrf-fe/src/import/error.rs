//! What can go wrong between a file and a finite-element model.

use std::path::{Path, PathBuf};

use ffrf_model::printable;

use crate::elements::ElementError;

/// What can go wrong between a file and a finite-element model.
///
/// Rows, columns and lines in messages count from 1, as in the files. What a message quotes of a file has its control
/// characters escaped, so that a damaged file cannot drive the terminal.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ImportError {
    /// A file cannot be read or written.
    #[error("{}: {source}", shown(path))]
    Io {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// A line of a file is not what its format asks for, such as `1 2 abc` for `row column value`.
    #[error("{}:{line}: expected {expected}, found {found}", shown(path))]
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
    #[error("{}:{line}: expected a finite number, found {found}", shown(path))]
    NonFinite {
        /// The file.
        path: PathBuf,
        /// Line number from 1; in a binary array the position of the value, from 1.
        line: usize,
        /// The number as it stands there.
        found: String,
    },
    /// A binary array (`.npy`, `.npz`) is not what is asked for.
    #[error("{}: {}expected {expected}, found {found}", shown(path), named_array(array))]
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
    #[error("{}:{line}: the file is cut off: expected {expected} {what}, found {found}", shown(path))]
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
    #[error("{}:{line}: {feature} is not supported here: {advice}", shown(path))]
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
    #[error("{}:{line}: node {id} is given a second time, at another position", shown(path))]
    DuplicateNode {
        /// The file.
        path: PathBuf,
        /// Line of the second definition, from 1.
        line: usize,
        /// The node id.
        id: u64,
    },
    /// The same node id stands in two rows of an array.
    #[error("{}: expected each node id once, found {id} again in row {row}", shown(path))]
    RepeatedNode {
        /// The file.
        path: PathBuf,
        /// Row of the second occurrence, from 1.
        row: usize,
        /// The node id.
        id: u64,
    },
    /// A node label of an instance, raised so that it does not clash, is too large.
    #[error(
        "{}:{line}: node label {id} of an instance cannot be raised by {raise} to be told from the labels before: \
         expected a sum below 2^64",
        shown(path)
    )]
    LabelOverflow {
        /// The file.
        path: PathBuf,
        /// Line of the node, from 1.
        line: usize,
        /// The label.
        id: u64,
        /// The largest label before.
        raise: u64,
    },
    /// A deck grows beyond all measure when its sets, instances or included files are written out.
    #[error("{}:{line}: expected at most {limit} {what}, found {found} or more", shown(path))]
    TooMany {
        /// The file.
        path: PathBuf,
        /// Line number from 1.
        line: usize,
        /// What is counted.
        what: &'static str,
        /// Most that is accepted.
        limit: u64,
        /// Number at which reading stopped.
        found: u64,
    },
    /// Matrices that a known element type has made unreadable.
    #[error("{}:{line}: element type {element}: {reason}; {fault}", shown(path))]
    ElementType {
        /// The deck.
        path: PathBuf,
        /// Line of the first elements of the type, from 1.
        line: usize,
        /// The element type.
        element: String,
        /// What is known of it.
        reason: &'static str,
        /// What is wrong with the matrices.
        fault: Box<ImportError>,
    },
    /// A solid of which no matrices can be made.
    #[error("{}:{line}: {fault}", shown(path))]
    BadElement {
        /// The mesh.
        path: PathBuf,
        /// Line number from 1.
        line: usize,
        /// What is wrong with it.
        fault: ElementError,
    },
    /// A mesh without solids.
    #[error("{}: expected tetrahedra or hexahedra, found {nodes} nodes and no solid: {advice}", shown(path))]
    NoSolids {
        /// The mesh.
        path: PathBuf,
        /// Number of nodes.
        nodes: usize,
        /// What to do.
        advice: &'static str,
    },
    /// A body that contradicts itself.
    #[error("{}: {fault}", shown(path))]
    Body {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        fault: Box<ffrf_model::ModelError>,
    },
    /// Constants that no elastic material has.
    #[error(
        "the material{} must have a density > 0, a Young's modulus > 0 and a Poisson's ratio between -1 and 1/2, found \
         {density:e}, {youngs_modulus:e} and {poisson_ratio}",
        of_group(group)
    )]
    Material {
        /// The group of solids; `None` for all that no named group holds.
        group: Option<String>,
        /// Density ρ. Units: kg/m³.
        density: f64,
        /// Young's modulus E. Units: N/m².
        youngs_modulus: f64,
        /// Poisson's ratio ν.
        poisson_ratio: f64,
    },
    /// A group of solids has two materials.
    #[error("the material{} is given a second time", of_group(group))]
    MaterialTwice {
        /// The group of solids; `None` for all that no named group holds.
        group: Option<String>,
    },
    /// A material for a group that holds no solids.
    #[error(
        "{}: no solid is in a group {}; groups of solids: {}",
        shown(path),
        printable(group),
        printable(known)
    )]
    UnknownSolids {
        /// The mesh.
        path: PathBuf,
        /// The group.
        group: String,
        /// The groups that hold solids.
        known: String,
    },
    /// Solids of which nothing says what they are made of.
    #[error(
        "{}:{line}: nothing says what this solid is made of, the first of {count}: name a material for its group, or one without \
         group for all others; groups of solids: {}",
        shown(path),
        printable(known)
    )]
    NoMaterial {
        /// The mesh.
        path: PathBuf,
        /// Line of the first, from 1.
        line: usize,
        /// How many there are.
        count: usize,
        /// The groups that hold solids.
        known: String,
    },
    /// A solid that two groups give a material.
    #[error(
        "{}:{line}: this solid is in the groups {} and {}, which both have a material",
        shown(path),
        printable(first),
        printable(second)
    )]
    TwoMaterials {
        /// The mesh.
        path: PathBuf,
        /// Line number from 1.
        line: usize,
        /// One group.
        first: String,
        /// The other.
        second: String,
    },
    /// A node id is not in the node table.
    #[error("{}:{line}: expected a node of the node table ({nodes} nodes), found node {id}", shown(path))]
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
    #[error("{}: expected nodes, found none", shown(path))]
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
    #[error("{}: expected a square matrix, found {rows} rows and {columns} columns", shown(path))]
    NotSquare {
        /// The file.
        path: PathBuf,
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
    /// Two inputs do not fit together in size.
    #[error("{}: expected {expected}, found {found} {what}", shown(path))]
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
        shown(path)
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
        shown(path)
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
        shown(path)
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
    #[error("{}: the {role} matrix of {size} rows cannot be factorised: {reason}", shown(path))]
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
    /// Nodes that one matrix knows and another does not.
    #[error(
        "{}: {count} {} {has} and no {lacks} ({listed}): complete the files, or say with --allow-massless that it is \
         meant",
        shown(path),
        if *count == 1 { "node has" } else { "nodes have" }
    )]
    OneSidedNodes {
        /// The file that lacks them.
        path: PathBuf,
        /// Number of such nodes.
        count: usize,
        /// Ids of the first of them, in words.
        listed: String,
        /// What they have: `mass` or `stiffness`, or the elements of the deck.
        has: &'static str,
        /// What they lack.
        lacks: &'static str,
    },
    /// A mass so large that it stands for a support, which a mass matrix cannot have.
    #[error(
        "{}: the diagonal entry of row {row} (node {node}) is {value:e} kg: expected less than {limit:e}, beyond which \
         Abaqus marks supports in a stiffness matrix",
        shown(path)
    )]
    HugeMass {
        /// The file.
        path: PathBuf,
        /// Row from 1.
        row: usize,
        /// Id of its node.
        node: u64,
        /// The entry. Units: kg.
        value: f64,
        /// Smallest value refused.
        limit: f64,
    },
    /// A mass matrix is not of the form that the user names, or a list does not say which form it is.
    #[error("{}: expected {expected}, found {found} rows for {nodes} nodes: {advice}", shown(path))]
    MassForm {
        /// The file.
        path: PathBuf,
        /// The form asked for.
        expected: String,
        /// Rows found.
        found: usize,
        /// Number of nodes N.
        nodes: usize,
        /// What to do.
        advice: &'static str,
    },
    /// The total mass is not positive.
    #[error("{}: expected a positive total mass, found {total:e} kg", shown(path))]
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
        shown(path)
    )]
    MassUnknown {
        /// The file.
        path: PathBuf,
        /// Number of nodes concerned.
        nodes: usize,
        /// Id of the first of them.
        first: u64,
    },
}

/// The array of an archive that a message is about; a `.npy` file has one without a name.
fn named_array(array: &str) -> String {
    if array.is_empty() { String::new() } else { format!("array `{array}`: ") }
}

/// ` of the group NAME`, or nothing.
fn of_group(group: &Option<String>) -> String {
    group.as_ref().map(|group| format!(" of the group {}", printable(group))).unwrap_or_default()
}

/// A path with its control characters escaped.
pub(super) fn shown(path: &Path) -> String {
    printable(&path.to_string_lossy())
}
