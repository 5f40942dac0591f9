//! What can go wrong between interfaces and component modes.

/// What can go wrong between interfaces and component modes.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ComponentModeError {
    /// A description of nodes or of an interface that cannot be read.
    #[error("`{text}`: {expected}")]
    Syntax {
        /// What was given.
        text: String,
        /// What was expected, and where it went wrong.
        expected: String,
    },
    /// A node set that the files do not have.
    #[error("there is no node set `{set}`: the files have {known}")]
    UnknownSet {
        /// The set asked for.
        set: String,
        /// The sets there are.
        known: String,
    },
    /// A node id that the files do not have.
    #[error("there is no node {id}: expected one of {nodes} ids from {first} to {last}")]
    UnknownNode {
        /// The id asked for.
        id: u64,
        /// Number of nodes.
        nodes: usize,
        /// Least id.
        first: u64,
        /// Greatest id.
        last: u64,
    },
    /// A selection without a node.
    #[error("{selection} holds none of the {nodes} nodes")]
    NothingSelected {
        /// The selection in words.
        selection: String,
        /// Number of nodes of the model.
        nodes: usize,
    },
    /// A component basis without an interface.
    #[error("a component mode basis needs at least one interface, got 0")]
    NoInterface,
    /// A name that cannot be a marker.
    #[error("interface `{interface}`: the name must be letters, digits and underscores, a letter first")]
    Name {
        /// Name of the interface.
        interface: String,
    },
    /// Two interfaces of one name.
    #[error("interface `{interface}` is given twice")]
    Repeated {
        /// Name of the interface.
        interface: String,
    },
    /// An interface at a row beyond the node table.
    #[error(
        "interface `{interface}`: node row {row} does not exist, the model has {nodes} nodes (rows from 0)"
    )]
    Row {
        /// Name of the interface.
        interface: String,
        /// The row asked for.
        row: usize,
        /// Number of nodes N.
        nodes: usize,
    },
    /// The rotation of the interface is not defined by its nodes.
    #[error(
        "interface `{interface}`: an interface needs at least 3 nodes off one line, but its {nodes} nodes spread by \
         only {spread:e} across their line, relative to their extent (least {least:e})"
    )]
    Collinear {
        /// Name of the interface.
        interface: String,
        /// Number of nodes.
        nodes: usize,
        /// Extent across the line over extent along it.
        spread: f64,
        /// Least spread accepted.
        least: f64,
    },
    /// Weights that do not fit the nodes.
    #[error(
        "interface `{interface}`: expected {nodes} positive finite weights, one for each node, found {found}"
    )]
    Weights {
        /// Name of the interface.
        interface: String,
        /// Number of nodes.
        nodes: usize,
        /// What was found, in words.
        found: String,
    },
    /// A node without mass and stiffness.
    #[error("interface `{interface}`: node {node} has neither mass nor stiffness")]
    Loose {
        /// Name of the interface.
        interface: String,
        /// Id of the node.
        node: u64,
    },
    /// A node that the export's boundary conditions hold.
    #[error("interface `{interface}`: node {node} is held by the boundary conditions of the export")]
    Held {
        /// Name of the interface.
        interface: String,
        /// Id of the node.
        node: u64,
    },
    /// A node that two rigid interfaces claim.
    #[error("node {node} belongs to the rigid interfaces `{first}` and `{second}`: it can follow only one")]
    Shared {
        /// Id of the node.
        node: u64,
        /// The one interface.
        first: String,
        /// The other.
        second: String,
    },
    /// A reference point that is not a point.
    #[error(
        "interface `{interface}`: expected three finite coordinates of the reference point, found {found:?}"
    )]
    ReferencePoint {
        /// Name of the interface.
        interface: String,
        /// What was found.
        found: [f64; 3],
    },
    /// The interfaces cannot move independently.
    #[error(
        "the {motions} motions of the interfaces do not move independently: the smallest pivot is {pivot:e} of the \
         largest (least {least:e}); do two interfaces share nodes?"
    )]
    Dependent {
        /// Number of interface motions.
        motions: usize,
        /// Smallest over largest eigenvalue of the scaled interface compliance.
        pivot: f64,
        /// Least ratio accepted.
        least: f64,
    },
    /// The stiffness resists rigid motion.
    #[error(
        "the stiffness matrix resists rigid motion: its strain energy is {ratio:e} of that of the lowest elastic \
         mode (accepted: {limit:e})"
    )]
    RigidMotionStrained {
        /// Rayleigh quotient of the worst rigid motion over the lowest elastic eigenvalue.
        ratio: f64,
        /// Largest ratio accepted.
        limit: f64,
    },
    /// More normal modes wanted than there are.
    #[error("{wanted} normal modes wanted, but only {available} exist")]
    TooFewModes {
        /// Modes asked for.
        wanted: usize,
        /// Modes there are.
        available: usize,
    },
    /// A basis without a shape that deforms.
    #[error("the basis has no shape left that deforms the part: {given} shapes were given")]
    EmptyBasis {
        /// Shapes before rigid motion and dependent shapes were removed.
        given: usize,
    },
    /// The dynamic stiffness cannot be solved at a frequency.
    #[error(
        "the response at {frequency_hz} Hz could not be solved: the residual is {residual:e} (accepted: {limit:e})"
    )]
    Response {
        /// Frequency. Units: Hz.
        frequency_hz: f64,
        /// ||f - (K - ω²M) u|| / ||f||.
        residual: f64,
        /// Largest residual accepted.
        limit: f64,
    },
    /// Shapes of different parts.
    #[error("{what}: expected {expected}, found {found}")]
    Size {
        /// What does not fit.
        what: String,
        /// Number expected.
        expected: usize,
        /// Number found.
        found: usize,
    },
    /// A number out of its range.
    #[error("{what}: expected {expected}, found {found}")]
    Number {
        /// Which number.
        what: String,
        /// The range.
        expected: String,
        /// The number.
        found: f64,
    },
    /// Bases that cannot be compared.
    #[error("bases of the same interfaces are expected, found those of {first:?} and of {other:?}")]
    OtherInterfaces {
        /// Interfaces of the first basis.
        first: Vec<String>,
        /// Those of another.
        other: Vec<String>,
    },
    /// An interface that no one defined.
    #[error("there is no interface `{interface}`: expected one of {known}")]
    UnknownInterface {
        /// The name asked for.
        interface: String,
        /// The names there are.
        known: String,
    },
}
