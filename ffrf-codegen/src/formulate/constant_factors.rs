//! The part of the factors of the mass matrix that does not depend on the state.

use super::factors::Factors;
use super::modal_mass::{ModalFactors, minus_products};
use super::solve::check_pivots;
use crate::CodegenError;
use crate::body::BodyExpressions;
use crate::expression::{Expression, Graph, Symmetric3, Vector};

/// Factors of Θ_ff and of what the modes leave of the mass, as the loops over lanes want them.
#[derive(Debug, Clone)]
pub struct ConstantFactors {
    /// Θ_ff = L D Lᵀ.
    pub modal: ModalFactors,
    /// L⁻¹ (m B)ᵀ. Shape: M rows of 3.
    pub first_moment: Vec<Vector>,
    /// One over the pivots of m I - m B Θ_ff⁻¹ (m B)ᵀ. Units: 1/kg.
    pub translation_inverse_pivots: Vector,
    /// Its factor below the diagonal: yx, zx, zy.
    pub translation_lower: Vector,
}

impl ConstantFactors {
    /// The factors of a body.
    ///
    /// Errors: [`CodegenError::RepeatedModes`] or [`CodegenError::DependentModes`] if Θ_ff or the reduced mass is a
    /// constant that is not positive definite.
    pub fn new(graph: &mut Graph, body: &BodyExpressions) -> Result<Self, CodegenError> {
        let modal = ModalFactors::new(graph, body)?;
        let axes = [0, 1, 2].map(|axis| {
            let moments: Vec<Expression> =
                body.modal_first_moment.iter().map(|moment| moment[axis]).collect();
            modal.forward(graph, &moments)
        });
        let weighted = axes.each_ref().map(|axis| -> Vec<Expression> {
            axis.iter().zip(&modal.inverse_pivots).map(|(&x, &w)| graph.multiply(w, x)).collect()
        });
        let zero = graph.zero();
        let mut rest = |i: usize, j: usize| {
            let start = if i == j { body.mass } else { zero };
            minus_products(graph, start, weighted[i].iter().copied().zip(axes[j].iter().copied()))
        };
        let mass = Symmetric3 {
            diagonal: [rest(0, 0), rest(1, 1), rest(2, 2)],
            off_diagonal: [rest(1, 2), rest(0, 2), rest(0, 1)],
        };
        let (translation, pivots) = Factors::new(graph, &mass);
        check_pivots(graph, pivots, body.mass)?;
        let [x, y, z] = axes;
        let first_moment = x.into_iter().zip(y).zip(z).map(|((x, y), z)| [x, y, z]).collect();
        Ok(Self {
            modal,
            first_moment,
            translation_inverse_pivots: translation.inverse_pivots,
            translation_lower: translation.lower,
        })
    }
}
