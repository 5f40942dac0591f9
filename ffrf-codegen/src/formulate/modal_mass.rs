//! Eliminating the modal accelerations: what has to be done with Θ_ff.

use super::pivot::{BadPivot, bad_pivot};
use crate::CodegenError;
use crate::body::BodyExpressions;
use crate::expression::{Expression, Graph};
use crate::layout::Structure;

/// Θ_ff, prepared for elimination. With constants as entries all of this folds when the code is generated.
#[derive(Debug, Clone)]
pub(super) enum ModalMass {
    /// Θ_ff = I
    Identity,
    /// 1 / Θ_ff,μμ
    Diagonal(Vec<Expression>),
    /// Θ_ff = L D Lᵀ.
    Factors(ModalFactors),
}

/// Θ_ff = L D Lᵀ with ones on the diagonal of L.
#[derive(Debug, Clone)]
pub struct ModalFactors {
    /// L below its diagonal: row μ has μ entries.
    pub lower: Vec<Vec<Expression>>,
    /// 1 / D. Shape: M.
    pub inverse_pivots: Vec<Expression>,
}

/// A vector x over the modes with a partner x' such that xᵀ Θ_ff⁻¹ y = x'·y'' for prepared x and y.
#[derive(Debug, Clone)]
pub(super) struct Prepared {
    left: Vec<Expression>,
    right: Vec<Expression>,
}

/// Up to this number of modes the addition that is saved outweighs the rounding: see [`Prepared::subtract_product`].
const SUBTRACTED_ONE_BY_ONE: usize = 2;

impl ModalMass {
    /// Errors: [`CodegenError::RepeatedModes`] if Θ_ff is a constant that is not positive definite.
    pub(super) fn new(graph: &mut Graph, body: &BodyExpressions) -> Result<Self, CodegenError> {
        let mass = &body.modal_mass;
        let one = graph.one();
        match body.modal_mass_structure {
            Structure::Zero | Structure::Identity => Ok(Self::Identity),
            Structure::Diagonal => {
                let mut inverse = Vec::with_capacity(mass.len());
                for (mu, row) in mass.iter().enumerate() {
                    check_pivot(graph, mu, row[mu], row[mu])?;
                    inverse.push(graph.divide(one, row[mu]));
                }
                Ok(Self::Diagonal(inverse))
            }
            _ => ModalFactors::new(graph, body).map(Self::Factors),
        }
    }

    /// Prepares a vector over the modes for products and for the elimination.
    pub(super) fn prepare(&self, graph: &mut Graph, vector: &[Expression]) -> Prepared {
        match self {
            Self::Identity => Prepared { left: vector.to_vec(), right: vector.to_vec() },
            Self::Diagonal(inverse) => Prepared {
                left: vector.iter().zip(inverse).map(|(&x, &w)| graph.multiply(w, x)).collect(),
                right: vector.to_vec(),
            },
            Self::Factors(factors) => {
                let right = factors.forward(graph, vector);
                let weights = right.iter().zip(&factors.inverse_pivots);
                Prepared { left: weights.map(|(&x, &w)| graph.multiply(w, x)).collect(), right }
            }
        }
    }

    /// Θ_ff⁻¹ (x - Σ_k y_k c_k) for prepared x and y_k.
    pub(super) fn solve(
        &self,
        graph: &mut Graph,
        vector: &Prepared,
        corrections: &[(&Prepared, Expression)],
    ) -> Vec<Expression> {
        let mut result = Vec::with_capacity(vector.left.len());
        for mu in 0..vector.left.len() {
            let terms = corrections.iter().map(|(prepared, factor)| (prepared.left[mu], *factor));
            result.push(minus_products(graph, vector.left[mu], terms));
        }
        match self {
            Self::Factors(factors) => factors.backward(graph, result),
            _ => result,
        }
    }
}

impl ModalFactors {
    /// The factors of Θ_ff, whatever its structure.
    ///
    /// Errors: [`CodegenError::RepeatedModes`] if Θ_ff is a constant that is not positive definite.
    pub fn new(graph: &mut Graph, body: &BodyExpressions) -> Result<Self, CodegenError> {
        let (mass, one) = (&body.modal_mass, graph.one());
        let mut lower: Vec<Vec<Expression>> = Vec::with_capacity(mass.len());
        let mut inverse_pivots: Vec<Expression> = Vec::with_capacity(mass.len());
        for i in 0..mass.len() {
            // L_ij D_j, then L_ij.
            let mut whole: Vec<Expression> = Vec::with_capacity(i);
            let mut row: Vec<Expression> = Vec::with_capacity(i);
            for j in 0..i {
                let rest = minus_products(graph, mass[i][j], (0..j).map(|k| (whole[k], lower[j][k])));
                row.push(graph.multiply(rest, inverse_pivots[j]));
                whole.push(rest);
            }
            let pivot = minus_products(graph, mass[i][i], (0..i).map(|k| (whole[k], row[k])));
            check_pivot(graph, i, pivot, mass[i][i])?;
            inverse_pivots.push(graph.divide(one, pivot));
            lower.push(row);
        }
        Ok(Self { lower, inverse_pivots })
    }

    /// L⁻¹ v
    pub fn forward(&self, graph: &mut Graph, vector: &[Expression]) -> Vec<Expression> {
        let mut solved: Vec<Expression> = Vec::with_capacity(vector.len());
        for (row, &entry) in self.lower.iter().zip(vector) {
            let terms = row.iter().zip(&solved).map(|(&factor, &known)| (factor, known));
            solved.push(minus_products(graph, entry, terms));
        }
        solved
    }

    /// L⁻ᵀ v
    fn backward(&self, graph: &mut Graph, mut vector: Vec<Expression>) -> Vec<Expression> {
        for i in (0..vector.len()).rev() {
            let terms = (i + 1..vector.len()).map(|k| (self.lower[k][i], vector[k]));
            vector[i] = minus_products(graph, vector[i], terms);
        }
        vector
    }
}

impl Prepared {
    /// start - xᵀ Θ_ff⁻¹ y
    ///
    /// More than a few products are summed before they are subtracted: `start` may be far larger than what remains,
    /// and each subtraction from it would round by its size.
    pub(super) fn subtract_product(&self, graph: &mut Graph, start: Expression, other: &Self) -> Expression {
        let terms = self.left.iter().zip(&other.right).map(|(&x, &y)| (x, y));
        if self.left.len() <= SUBTRACTED_ONE_BY_ONE {
            return minus_products(graph, start, terms);
        }
        let zero = graph.zero();
        let sum = graph.sum_of_products(zero, terms);
        graph.subtract(start, sum)
    }
}

fn check_pivot(graph: &Graph, mode: usize, pivot: Expression, entry: Expression) -> Result<(), CodegenError> {
    match bad_pivot(graph, pivot, entry) {
        Some(BadPivot { found, expected }) => Err(CodegenError::RepeatedModes { mode, found, expected }),
        None => Ok(()),
    }
}

/// start - Σ a_k b_k
pub(super) fn minus_products(
    graph: &mut Graph,
    start: Expression,
    factors: impl IntoIterator<Item = (Expression, Expression)>,
) -> Expression {
    let mut total = start;
    for (a, b) in factors {
        let product = graph.multiply(a, b);
        total = graph.subtract(total, product);
    }
    total
}
