//! What can go wrong between a model and its modes.

/// What can go wrong between a model and its modes.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ModeError {
    /// Modes were asked of a model without a stiffness matrix.
    #[error("modes need a stiffness matrix, and the model has none")]
    MissingStiffness,
    /// No mode was asked for, or given.
    #[error("expected at least one mode, got 0")]
    NoModesWanted,
    /// A matrix does not fit the node table.
    #[error("the {what} matrix: expected {expected} x {expected}, found {rows} x {columns}")]
    MatrixSize {
        /// `mass` or `stiffness`.
        what: String,
        /// Rows and columns that the node table asks for.
        expected: usize,
        /// Rows found.
        rows: usize,
        /// Columns found.
        columns: usize,
    },
    /// A node set without a node.
    #[error("expected at least one node for {purpose}, got 0")]
    EmptyNodeSet {
        /// What the set is for.
        purpose: String,
    },
    /// A row beyond the node table.
    #[error("node row {row} does not exist: the model has {nodes} nodes (rows from 0)")]
    UnknownNodeRow {
        /// The row asked for.
        row: usize,
        /// Number of nodes N.
        nodes: usize,
    },
    /// Every degree of freedom is held.
    #[error("nothing is free to move: {held} degrees of freedom are held")]
    NothingFree {
        /// Number of held degrees of freedom.
        held: usize,
    },
    /// The mass matrix sums to nothing.
    #[error("expected a positive total mass, found {mass:e}")]
    MassNotPositive {
        /// Sum of all entries of M_s. Units: kg.
        mass: f64,
    },
    /// Nothing in the model can be strained.
    #[error("the free part of the model has no vibration: mean stiffness {stiffness:e}, mean mass {mass:e}")]
    NoStrain {
        /// Sum of the diagonal of K. Units: N/m.
        stiffness: f64,
        /// Sum of the diagonal of M. Units: kg.
        mass: f64,
    },
    /// K resists motions that should be rigid.
    #[error(
        "the stiffness resists rigid motion: Rayleigh quotient {ratio:e} of the lowest elastic one (limit {limit:e}), \
         residual {residual:e}; the export holds the part by springs or boundary conditions that it does not name, \
         or its node table does not belong to its matrices"
    )]
    RigidMotionStrained {
        /// rᵀKr / rᵀMr over the elastic scale.
        ratio: f64,
        /// Largest ratio accepted.
        limit: f64,
        /// ||K r|| / || |K| |r| ||.
        residual: f64,
    },
    /// A matrix that must be positive definite is not.
    #[error("{what} is not positive definite: pivot {pivot} of {size} is not positive")]
    NotPositiveDefinite {
        /// The matrix.
        what: String,
        /// Number of the pivot from 0, in the order of elimination.
        pivot: usize,
        /// Size of the matrix.
        size: usize,
    },
    /// A pivot vanished while eigenvalues were counted.
    #[error(
        "counting eigenvalues: a pivot of the {size} vanished or is not finite; ask for another number of modes, so \
         that the count is made elsewhere"
    )]
    ZeroPivot {
        /// Size of the matrix.
        size: usize,
    },
    /// The sparse factor does not fit into memory or into its index type.
    #[error(
        "the sparse factor of a matrix with {size} rows does not fit into memory or into its 32-bit indices; use a \
         coarser mesh, or compute the modes in the finite-element program and give the mode shapes"
    )]
    FactorTooLarge {
        /// Size of the matrix.
        size: usize,
    },
    /// The dense eigenvalue iteration failed.
    #[error("the eigenvalues of a symmetric {size} x {size} matrix were not found: are its entries finite?")]
    EigenvaluesNotFound {
        /// Size of the matrix.
        size: usize,
    },
    /// More modes are wanted than the model has.
    #[error(
        "{wanted} elastic modes are wanted, but the model has only {available}: ask for at most that many"
    )]
    TooFewModes {
        /// Modes asked for.
        wanted: usize,
        /// Elastic modes that exist.
        available: usize,
    },
    /// The iteration did not converge.
    #[error(
        "{converged} of {wanted} modes have converged after {restarts} restarts of the iteration; entries of K or M of \
         very different size (units mixed up, springs far stiffer than the part) slow it down; ask for fewer modes, or \
         for the dense method if the model is small"
    )]
    NotConverged {
        /// Modes asked for, guards included.
        wanted: usize,
        /// Modes converged.
        converged: usize,
        /// Restarts spent.
        restarts: usize,
    },
    /// The vectors of the iteration do not fit into memory.
    #[error(
        "the search for the modes needs {vectors} vectors of {size} values, {} MB, which do not fit into memory; ask \
         for fewer modes",
        vectors.saturating_mul(*size) / 131_072
    )]
    SubspaceTooLarge {
        /// Length of each vector.
        size: usize,
        /// Number of vectors.
        vectors: usize,
    },
    /// The Sturm count contradicts the modes found.
    #[error(
        "{counted} eigenvalues lie below {below_hz} Hz by Sturm count, but {found} were found; ask for some modes more \
         or fewer, so that the count is made elsewhere; if that does not help, K or M is not positive semidefinite"
    )]
    ModesMissed {
        /// Eigenvalues below the limit by the signs of pivots.
        counted: usize,
        /// Eigenvalues found below the limit, rigid-body modes included.
        found: usize,
        /// The limit. Units: Hz.
        below_hz: f64,
    },
    /// The last wanted mode could not be told from its neighbours.
    #[error(
        "no clear gap follows the last wanted mode among {wanted} modes, all of nearly the same frequency: ask for fewer \
         modes, so that the last lies before them"
    )]
    NoClearGap {
        /// Modes searched.
        wanted: usize,
    },
    /// Mode shapes with a wrong number of rows.
    #[error("mode shapes: expected {expected} rows (3 for each of {nodes} nodes), found {found}")]
    ModeShapeRows {
        /// Number of nodes N.
        nodes: usize,
        /// 3 N.
        expected: usize,
        /// Rows found.
        found: usize,
    },
    /// A mode shape with a value that is not finite.
    #[error("mode shapes: the value in row {row}, column {column} (from 0) is not finite")]
    ModeShapeNotFinite {
        /// Row from 0.
        row: usize,
        /// Column from 0.
        column: usize,
    },
}
