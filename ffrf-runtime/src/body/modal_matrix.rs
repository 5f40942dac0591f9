//! Symmetric matrices over the modes: diagonal where they are, dense where they must be.

use nalgebra::RealField;

use super::ModalVector;
use crate::six::scaled;

/// A symmetric matrix over the modes of a body: Θ_ff, K_ff or D_ff. Shape: M x M.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ModalMatrix<V: ModalVector<T>, T: RealField + Copy> {
    /// The diagonal; all else is zero. Shape: M.
    Diagonal(V),
    /// Every entry.
    Dense(V::Matrix),
}

/// Factors of a symmetric positive definite matrix over the modes.
#[derive(Debug, Clone, Copy)]
pub enum ModalFactors<V: ModalVector<T>, T: RealField + Copy> {
    /// The inverse of the diagonal.
    Diagonal(V),
    /// Factors of a dense matrix.
    Dense(V::Factors),
}

impl<V: ModalVector<T>, T: RealField + Copy> ModalMatrix<V, T> {
    /// Matrix times vector. Shape: M.
    #[inline]
    pub fn product(&self, vector: &V) -> V {
        match self {
            Self::Diagonal(diagonal) => diagonal.times(vector),
            Self::Dense(matrix) => V::product(matrix, vector),
        }
    }

    /// Every entry. Shape: M x M.
    pub fn dense(&self) -> V::Matrix {
        match self {
            Self::Diagonal(diagonal) => diagonal.diagonal_matrix(),
            Self::Dense(matrix) => matrix.clone(),
        }
    }

    /// One entry; `None` beyond the modes.
    pub(crate) fn entry(&self, row: usize, column: usize) -> Option<T> {
        match self {
            Self::Diagonal(diagonal) if row == column => diagonal.as_slice().get(row).copied(),
            Self::Diagonal(diagonal) => (row.max(column) < diagonal.as_slice().len()).then(T::zero),
            Self::Dense(matrix) => V::entry(matrix, row, column),
        }
    }

    /// `self + factor * other`; diagonal if both are.
    pub fn plus(&self, factor: T, other: &Self) -> Self {
        match (self, other) {
            (Self::Diagonal(diagonal), Self::Diagonal(other)) => {
                let mut sum = diagonal.clone();
                sum.add_scaled(factor, other);
                Self::Diagonal(sum)
            }
            _ => Self::Dense(V::combination(&self.dense(), factor, &other.dense())),
        }
    }

    /// The factors, or `None` if the matrix is not positive definite.
    pub fn factor(&self) -> Option<ModalFactors<V, T>> {
        match self {
            Self::Diagonal(diagonal) => {
                let mut inverse = diagonal.clone();
                for entry in inverse.as_mut_slice() {
                    // a NaN fails this comparison as well
                    let positive = *entry > T::zero();
                    if !positive || !entry.is_finite() {
                        return None;
                    }
                    *entry = T::one() / *entry;
                }
                Some(ModalFactors::Diagonal(inverse))
            }
            Self::Dense(matrix) => V::factor(matrix).map(ModalFactors::Dense),
        }
    }
}

impl<V: ModalVector<T>, T: RealField + Copy> ModalFactors<V, T> {
    /// The solution of the factored matrix times x = `right`. Shape: M.
    #[inline]
    pub fn solve(&self, right: &V) -> V {
        match self {
            Self::Diagonal(inverse) => inverse.times(right),
            Self::Dense(factors) => V::solve(factors, right),
        }
    }

    /// Solves with six right-hand sides in place. Shape: M x 6.
    #[inline]
    pub fn solve_sixes(&self, right: &mut V::Sixes) {
        match self {
            Self::Diagonal(inverse) => {
                for (six, inverse) in right.as_mut().iter_mut().zip(inverse.as_slice()) {
                    *six = scaled(*inverse, six);
                }
            }
            Self::Dense(factors) => V::solve_sixes(factors, right),
        }
    }

    /// Sets the solutions of six right-hand sides. Shape: M x 6.
    #[inline]
    pub(crate) fn solve_sixes_to(&self, solution: &mut V::Sixes, right: &V::Sixes) {
        match self {
            Self::Diagonal(inverse) => {
                let places = solution.as_mut().iter_mut().zip(right.as_ref());
                for ((place, six), inverse) in places.zip(inverse.as_slice()) {
                    *place = scaled(*inverse, six);
                }
            }
            Self::Dense(factors) => {
                solution.clone_from(right);
                V::solve_sixes(factors, solution);
            }
        }
    }
}
