//! Signatures: what a kernel takes and gives, and what its documentation says.

use crate::expression::{Extent, Input};

/// What stands about a kernel before its expressions: arguments, results and documentation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Signature {
    /// Name of the function. Kernels of one body are told apart by it.
    pub name: &'static str,
    /// The arguments, in order.
    pub inputs: &'static [Input],
    /// The results, in order.
    pub outputs: &'static [Output],
    /// Name of the struct that holds several results; empty if there is one.
    pub results: &'static str,
    /// What it computes, in a sentence.
    pub title: &'static str,
    /// Units of the results.
    pub units: &'static str,
    /// Equation or definition.
    pub source: &'static str,
}

/// A result of a kernel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Output {
    /// Its name: that of the field where there are several.
    pub name: &'static str,
    /// Its shape.
    pub shape: Shape,
}

/// The shape of a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// One number.
    Scalar,
    /// A column.
    Vector(Extent),
    /// A motion as one column: linear, angular, modal.
    Motion,
    /// A generalised force as one column: force, moment, modal forces.
    Force,
    /// A symmetric matrix, column by column.
    Symmetric(Extent),
    /// A matrix, column by column.
    Columns {
        /// Length of a column.
        rows: Extent,
        /// How many of them.
        columns: Extent,
    },
}

impl Shape {
    /// Number of columns of a matrix; of anything else, 1.
    pub fn columns(self, mode_count: usize) -> usize {
        match self {
            Self::Scalar | Self::Vector(_) | Self::Motion | Self::Force => 1,
            Self::Symmetric(columns) | Self::Columns { columns, .. } => columns.size(mode_count),
        }
    }

    /// Number of entries.
    pub fn entries(self, mode_count: usize) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Vector(extent) => extent.size(mode_count),
            Self::Motion | Self::Force => Extent::Velocities.size(mode_count),
            Self::Symmetric(extent) => extent.size(mode_count).pow(2),
            Self::Columns { rows, columns } => rows.size(mode_count) * columns.size(mode_count),
        }
    }
}

impl Signature {
    /// Number of entries of all results.
    pub fn entries(&self, mode_count: usize) -> usize {
        self.outputs.iter().map(|output| output.shape.entries(mode_count)).sum()
    }
}
