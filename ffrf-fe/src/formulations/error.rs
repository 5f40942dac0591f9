//! What can go wrong in the formulations.

/// What can go wrong in the formulations.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FormulationError {
    /// A model without stiffness cannot move elastically.
    #[error("the model has no stiffness matrix")]
    MissingStiffness,
    /// A matrix or vector has the wrong size.
    #[error("{what} has {found} rows, expected {expected}")]
    Size {
        /// Which one.
        what: &'static str,
        /// Rows needed.
        expected: usize,
        /// Rows found.
        found: usize,
    },
    /// A node number beyond the mesh.
    #[error("node {node} does not exist: the body has {nodes} (from 0)")]
    UnknownNode {
        /// The number.
        node: usize,
        /// Number of nodes.
        nodes: usize,
    },
    /// The points do not define a rotation: they lie on a line, or the mean deformation is singular.
    #[error("the frame has no rotation: its points span only {extent:e} across their main direction")]
    DegenerateFrame {
        /// Measure that should not vanish.
        extent: f64,
    },
    /// The matrix of the implicit step is not positive definite.
    #[error(
        "4/h² M + K is not positive definite: mass or stiffness are, or the generalised modes are dependent"
    )]
    NotPositiveDefinite,
    /// Newton's iteration did not converge.
    #[error("no convergence at t = {time} s: correction {correction:e} after {iterations} iterations")]
    NoConvergence {
        /// Time at the start of the step. Units: s.
        time: f64,
        /// Last correction relative to the size of the body.
        correction: f64,
        /// Iterations done.
        iterations: usize,
    },
    /// An element that cannot be integrated.
    #[error("element {element}: {defect}")]
    Element {
        /// Number of the element from 0.
        element: usize,
        /// What is wrong, with the numbers.
        defect: ElementDefect,
    },
}

/// What can be wrong with an element.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ElementDefect {
    /// No quadrature for this shape.
    #[error("no quadrature for elements of kind {kind:?}")]
    Unsupported {
        /// The kind.
        kind: crate::ElementKind,
    },
    /// A wrong number of nodes.
    #[error("{expected} nodes expected, found {found}")]
    NodeCount {
        /// Nodes of such an element.
        expected: usize,
        /// Nodes given.
        found: usize,
    },
    /// A node that the mesh does not have.
    #[error("node row {row} does not exist, there are {nodes}")]
    UnknownNode {
        /// The row from 0.
        row: usize,
        /// Nodes of the mesh.
        nodes: usize,
    },
    /// Inside out or flat.
    #[error("Jacobian determinant {determinant:e}: inside out or flat")]
    Jacobian {
        /// The determinant. Units: m³.
        determinant: f64,
    },
}
