//! Vectors over the modes whose number is known at run time.

use ffrf_runtime::ModalVector;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Numbers, one for each mode.
#[derive(Debug, Clone, PartialEq)]
pub struct HostModal(pub DVector<f64>);

impl HostModal {
    /// Zeros. Shape: `modes`.
    pub fn zeros(modes: usize) -> Self {
        Self(DVector::zeros(modes))
    }
}

impl ModalVector<f64> for HostModal {
    type Matrix = DMatrix<f64>;
    type Factors = Cholesky<f64, Dyn>;

    fn as_slice(&self) -> &[f64] {
        self.0.as_slice()
    }

    fn as_mut_slice(&mut self) -> &mut [f64] {
        self.0.as_mut_slice()
    }

    fn product(matrix: &Self::Matrix, vector: &Self) -> Self {
        Self(matrix * &vector.0)
    }

    fn combination(matrix: &Self::Matrix, factor: f64, other: &Self::Matrix) -> Self::Matrix {
        matrix + other * factor
    }

    fn diagonal_matrix(&self) -> Self::Matrix {
        DMatrix::from_diagonal(&self.0)
    }

    fn factor(matrix: &Self::Matrix) -> Option<Self::Factors> {
        Cholesky::new(matrix.clone())
    }

    fn solve(factors: &Self::Factors, right: &Self) -> Self {
        Self(factors.solve(&right.0))
    }
}
