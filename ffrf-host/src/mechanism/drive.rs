//! Motions that are given as functions of time.

use ffrf_runtime::mechanism::polynomial;

use super::Formula;

/// A function of time with its exact first and second derivative.
#[derive(Debug, Clone, PartialEq)]
pub enum Drive {
    /// Σ c_k t^k.
    Polynomial(Vec<f64>),
    /// A formula in t.
    Formula(Formula),
    /// A smooth curve through given points.
    Table(super::Table),
}

impl Drive {
    /// Value, rate and acceleration at `time` (s).
    pub fn at(&self, time: f64) -> [f64; 3] {
        match self {
            Self::Polynomial(coefficients) => polynomial(coefficients, time),
            Self::Formula(formula) => formula.at(time),
            Self::Table(table) => table.at(time),
        }
    }
}
