//! Equations of motion as polynomials, and where two of them differ.

use ffrf_codegen::derive::EulerPoincare;
use ffrf_codegen::expression::{Expression, Graph, Symbol};
use ffrf_codegen::polynomial::{Polynomial, polynomials_of};

/// Mass matrix (rows, then columns) and quadratic velocity vector, as polynomials.
pub struct Equations {
    /// Shape: N x N.
    pub mass_matrix: Vec<Vec<Polynomial<Symbol>>>,
    /// Shape: N.
    pub quadratic_velocity: Vec<Polynomial<Symbol>>,
}

impl Equations {
    /// The polynomials of these expressions.
    pub fn of(graph: &Graph, mass_matrix: &[Vec<Expression>], quadratic_velocity: &[Expression]) -> Self {
        let entries: Vec<Expression> =
            mass_matrix.iter().flatten().chain(quadratic_velocity).copied().collect();
        let mut polynomials = polynomials_of(graph, &entries).unwrap();
        assert_eq!(graph.rounded_folds(), 0, "constants were rounded: the proof would not be exact");
        let quadratic_velocity = polynomials.split_off(polynomials.len() - quadratic_velocity.len());
        let size = quadratic_velocity.len();
        let mass_matrix = polynomials.chunks(size).map(<[_]>::to_vec).collect();
        Self { mass_matrix, quadratic_velocity }
    }

    /// The polynomials of what the energy implies.
    pub fn derived(graph: &Graph, equations: &EulerPoincare) -> Self {
        Self::of(graph, &equations.mass_matrix, &equations.quadratic_velocity)
    }

    /// Number of monomials in all entries.
    pub fn monomials(&self) -> usize {
        let entries = self.mass_matrix.iter().flatten().chain(&self.quadratic_velocity);
        entries.map(Polynomial::term_count).sum()
    }

    /// One line for each entry that differs; empty if and only if the equations are the same.
    pub fn differences(&self, other: &Self) -> Vec<String> {
        assert_eq!(self.quadratic_velocity.len(), other.quadratic_velocity.len());
        let mut lines = Vec::new();
        let mut compare = |name: String, left: &Polynomial<Symbol>, right: &Polynomial<Symbol>| {
            if left != right {
                lines.push(format!("{name}: {}", left.subtract(right).unwrap()));
            }
        };
        for (row, (left, right)) in self.mass_matrix.iter().zip(&other.mass_matrix).enumerate() {
            assert_eq!(left.len(), right.len());
            for (column, (left, right)) in left.iter().zip(right).enumerate() {
                compare(format!("M[{row}][{column}]"), left, right);
            }
        }
        for (row, (left, right)) in self.quadratic_velocity.iter().zip(&other.quadratic_velocity).enumerate()
        {
            compare(format!("Q[{row}]"), left, right);
        }
        lines
    }
}
