//! Consistent and lumped scalar mass matrices from the same quadrature.

use std::collections::BTreeMap;

use faer::sparse::Triplet;

use super::element_points;
use crate::formulations::FormulationError;
use crate::{Element, SparseMatrix};

/// How the mass of an element reaches its nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum LumpedMass {
    /// Not lumped: ∫ρ N_a N_b, (4).
    Consistent,
    /// Sum of each row, ∫ρ N_a. Negative at the corners of quadratic elements: unusable there.
    RowSum,
    /// Hinton, Rock & Zienkiewicz (1976): the diagonal ∫ρ N_a², scaled to the element's mass.
    ScaledDiagonal,
}

impl LumpedMass {
    /// Scalar mass matrix M_s of a mesh. Shape: N x N. Units: kg for a density in kg/m³.
    ///
    /// Errors: [`FormulationError::Element`].
    pub fn assemble(
        self,
        positions: &[[f64; 3]],
        elements: &[Element],
        density: f64,
    ) -> Result<SparseMatrix, FormulationError> {
        let mut sums: BTreeMap<(usize, usize), f64> = BTreeMap::new();
        for (number, element) in elements.iter().enumerate() {
            let points = element_points(positions, element, number)?;
            let integral = |f: &dyn Fn(&[f64]) -> f64| {
                points.iter().map(|point| density * point.volume * f(&point.shape)).sum::<f64>()
            };
            let (mass, trace) = (integral(&|_| 1.0), integral(&|n| n.iter().map(|x| x * x).sum()));
            for (a, &row) in element.nodes.iter().enumerate() {
                match self {
                    Self::Consistent => {
                        for (b, &column) in element.nodes.iter().enumerate() {
                            *sums.entry((column, row)).or_default() += integral(&|n| n[a] * n[b]);
                        }
                    }
                    Self::RowSum => *sums.entry((row, row)).or_default() += integral(&|n| n[a]),
                    Self::ScaledDiagonal => {
                        *sums.entry((row, row)).or_default() += integral(&|n| n[a] * n[a]) * mass / trace;
                    }
                }
            }
        }
        let entries: Vec<_> =
            sums.into_iter().map(|((column, row), value)| Triplet::new(row, column, value)).collect();
        let (size, found) = (positions.len(), entries.len());
        SparseMatrix::try_new_from_triplets(size, size, &entries).map_err(|_| FormulationError::Size {
            what: "the list of mass entries",
            expected: size,
            found,
        })
    }
}
