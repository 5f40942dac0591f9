//! What can go wrong with elements.

use crate::ElementKind;

/// What can go wrong with elements.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ElementError {
    /// A wrong number of nodes.
    #[error("an element of kind {kind:?} has {expected} nodes, found {found}")]
    NodeCount {
        /// The kind.
        kind: ElementKind,
        /// Nodes of such an element.
        expected: usize,
        /// Nodes given.
        found: usize,
    },
    /// An element that is inside out or flat.
    #[error(
        "the Jacobian determinant is {determinant:e} at a quadrature point: the element is inside out or flat"
    )]
    Jacobian {
        /// The determinant. Units: m³.
        determinant: f64,
    },
    /// An element of numbers that cannot be added up.
    #[error("an entry of its matrices is {value:e}: expected less than {limit:e}")]
    TooLarge {
        /// The entry. Units: kg or N/m.
        value: f64,
        /// Smallest value refused.
        limit: f64,
    },
    /// An element of a model that has a fault of its own.
    #[error("element {element} (from 0): {fault}")]
    Numbered {
        /// Number of the element from 0.
        element: usize,
        /// What is wrong with it.
        fault: Box<ElementError>,
    },
    /// An element of which nothing says what it is made of.
    #[error("element {element} (from 0): expected one of {materials} materials, found none or another")]
    NoMaterial {
        /// Number of the element from 0.
        element: usize,
        /// Number of materials.
        materials: usize,
    },
    /// An element at a row beyond the node table.
    #[error("element {element}: node row {row} does not exist, there are {nodes} nodes (rows from 0)")]
    UnknownNode {
        /// Number of the element from 0.
        element: usize,
        /// The row.
        row: usize,
        /// Number of nodes N.
        nodes: usize,
    },
}
