//! Orthonormal combinations of generalised modes, without the dependent ones.
//!
//! The scalar fields {1, xⁱ, φ_μⁱ} of many modes are nearly dependent: bending in two planes moves by the same w(x),
//! and a complete basis has 9M fields for 3N numbers. The motion is the same in any basis of their span; an
//! orthonormal one keeps the equations well conditioned.

use faer::{Mat, Side};

use super::model::dense_as_sparse;
use super::{CorotatedModel, GroundJoint};
use crate::formulations::FormulationError;

/// Fields weaker than this part of the strongest one, in the norm of the mass, count as dependent.
///
/// Eigenvalues of the Gram matrix carry its square; below it they are round-off of the matrix products.
const DEPENDENT: f64 = 1e-6;

/// The recombination W: old fields' coordinates are W times the new ones.
#[derive(Debug, Clone)]
pub struct Recombination {
    /// W with Wᵀ Gram W = I. Shape: old x new.
    pub columns: Mat<f64>,
}

impl CorotatedModel {
    /// The same body in orthonormal combinations of its fields, M̄ = I; for generalised modes.
    ///
    /// Errors: [`FormulationError::NotPositiveDefinite`] if the eigenvalues of the Gram matrix cannot be found.
    pub fn orthonormal(&self) -> Result<(Self, Recombination), FormulationError> {
        let count = self.triples();
        let gram = &self.scalar_mass * Mat::<f64>::identity(count, count);
        // Fields of unit norm first: their sizes differ with the units of x and φ.
        let norms: Vec<f64> = (0..count).map(|n| gram[(n, n)].sqrt()).collect();
        let unit = Mat::from_fn(count, count, |i, j| gram[(i, j)] / (norms[i] * norms[j]));
        let eigen =
            unit.self_adjoint_eigen(Side::Lower).map_err(|_| FormulationError::NotPositiveDefinite)?;
        let largest = eigen.S()[count - 1];
        let kept: Vec<usize> =
            (0..count).filter(|&k| eigen.S()[k] > DEPENDENT * DEPENDENT * largest).collect();
        let columns = Mat::from_fn(count, kept.len(), |n, k| {
            eigen.U()[(n, kept[k])] / (norms[n] * eigen.S()[kept[k]].sqrt())
        });
        let wide = Mat::from_fn(3 * count, 3 * kept.len(), |row, column| {
            if row % 3 == column % 3 { columns[(row / 3, column / 3)] } else { 0.0 }
        });
        // New coordinates of a given motion: Wᵀ Gram r, exact for motions within the span.
        let onto = columns.transpose() * &gram;
        let reference = Mat::from_fn(3 * kept.len(), 1, |row, _| {
            (0..count).map(|n| onto[(row / 3, n)] * self.reference[(3 * n + row % 3, 0)]).sum()
        });
        let translation =
            (0..kept.len()).map(|k| (0..count).map(|n| onto[(k, n)] * self.translation[n]).sum()).collect();
        let stiffness = wide.transpose() * (&self.stiffness * &wide);
        let reduced = Self {
            reference,
            scalar_mass: dense_as_sparse(&Mat::identity(kept.len(), kept.len()))?,
            stiffness: dense_as_sparse(&stiffness)?,
            translation,
            nonlinear_term: self.nonlinear_term,
        };
        Ok((reduced, Recombination { columns }))
    }
}

impl Recombination {
    /// The same joint on the new coordinates.
    pub fn joint(&self, joint: &GroundJoint) -> GroundJoint {
        let weights = (0..self.columns.ncols())
            .map(|k| (k, joint.weights.iter().map(|&(n, w)| w * self.columns[(n, k)]).sum()))
            .collect();
        GroundJoint { weights }
    }
}
