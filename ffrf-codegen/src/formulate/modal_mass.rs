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
    /// Θ_ff = L Lᵀ, with the inverse of L's diagonal apart.
    Cholesky { lower: Vec<Vec<Expression>>, inverse_diagonal: Vec<Expression> },
}

/// A vector x over the modes with a partner x' such that xᵀ Θ_ff⁻¹ y = x'·y'' for prepared x and y.
#[derive(Debug, Clone)]
pub(super) struct Prepared {
    left: Vec<Expression>,
    right: Vec<Expression>,
}

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
            _ => Self::cholesky(graph, mass),
        }
    }

    fn cholesky(graph: &mut Graph, mass: &[Vec<Expression>]) -> Result<Self, CodegenError> {
        let one = graph.one();
        let mut lower: Vec<Vec<Expression>> = Vec::with_capacity(mass.len());
        let mut inverse_diagonal = Vec::with_capacity(mass.len());
        for i in 0..mass.len() {
            let mut row = Vec::with_capacity(i);
            for j in 0..i {
                let sum = minus_products(graph, mass[i][j], (0..j).map(|k| (row[k], lower[j][k])));
                row.push(graph.multiply(sum, inverse_diagonal[j]));
            }
            let pivot = minus_products(graph, mass[i][i], row.iter().map(|&entry| (entry, entry)));
            check_pivot(graph, i, pivot, mass[i][i])?;
            let root = graph.square_root(pivot);
            inverse_diagonal.push(graph.divide(one, root));
            lower.push(row);
        }
        Ok(Self::Cholesky { lower, inverse_diagonal })
    }

    /// Prepares a vector over the modes for products and for the elimination.
    pub(super) fn prepare(&self, graph: &mut Graph, vector: &[Expression]) -> Prepared {
        match self {
            Self::Identity => Prepared { left: vector.to_vec(), right: vector.to_vec() },
            Self::Diagonal(inverse) => Prepared {
                left: vector.iter().zip(inverse).map(|(&x, &w)| graph.multiply(w, x)).collect(),
                right: vector.to_vec(),
            },
            Self::Cholesky { lower, inverse_diagonal } => {
                let mut solved: Vec<Expression> = Vec::with_capacity(vector.len());
                for i in 0..vector.len() {
                    let terms = (0..i).map(|k| (lower[i][k], solved[k]));
                    let sum = minus_products(graph, vector[i], terms);
                    solved.push(graph.multiply(sum, inverse_diagonal[i]));
                }
                Prepared { left: solved.clone(), right: solved }
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
        if let Self::Cholesky { lower, inverse_diagonal } = self {
            for i in (0..result.len()).rev() {
                let terms = (i + 1..result.len()).map(|k| (lower[k][i], result[k]));
                let sum = minus_products(graph, result[i], terms);
                result[i] = graph.multiply(sum, inverse_diagonal[i]);
            }
        }
        result
    }
}

impl Prepared {
    /// start - xᵀ Θ_ff⁻¹ y
    pub(super) fn subtract_product(&self, graph: &mut Graph, start: Expression, other: &Self) -> Expression {
        let terms = self.left.iter().zip(&other.right).map(|(&x, &y)| (x, y));
        minus_products(graph, start, terms)
    }
}

/// Θ_ff⁻¹. Shape: M x M.
///
/// Errors: [`CodegenError::RepeatedModes`].
pub fn inverse_modal_mass(
    graph: &mut Graph,
    body: &BodyExpressions,
) -> Result<Vec<Vec<Expression>>, CodegenError> {
    let modes = body.mode_count();
    let mass = ModalMass::new(graph, body)?;
    let (zero, one) = (graph.zero(), graph.one());
    let columns = (0..modes)
        .map(|mu| {
            let unit: Vec<Expression> = (0..modes).map(|nu| if nu == mu { one } else { zero }).collect();
            let prepared = mass.prepare(graph, &unit);
            mass.solve(graph, &prepared, &[])
        })
        .collect();
    Ok(columns)
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
