//! Vectors over the modes of a body, of fixed size on the target and of run-time size on the host.

use core::fmt;

use nalgebra::{Cholesky, Const, RealField, SMatrix, SVector};

/// Numbers, one for each mode of a body, with the matrices and factorisations that go with them.
///
/// Everything that works on bodies is written against this trait, so that a body with a mode count known at compile
/// time ([`SVector`], on the stack) and one with a mode count known at run time share every line of it.
pub trait ModalVector<T: RealField + Copy>: Clone + PartialEq + fmt::Debug {
    /// A symmetric matrix over the modes. Shape: M x M.
    type Matrix: Clone + PartialEq + fmt::Debug;
    /// Factors of a symmetric positive definite [`Matrix`](Self::Matrix).
    type Factors: Clone + fmt::Debug;
    /// Six numbers for each mode. Shape: M x 6.
    type Sixes: Clone + PartialEq + fmt::Debug + AsRef<[[T; 6]]> + AsMut<[[T; 6]]>;

    /// The numbers. Shape: M.
    fn as_slice(&self) -> &[T];
    /// The numbers, to write to. Shape: M.
    fn as_mut_slice(&mut self) -> &mut [T];
    /// Matrix times vector. Shape: M.
    fn product(matrix: &Self::Matrix, vector: &Self) -> Self;
    /// `matrix + factor * other`. Shape: M x M.
    fn combination(matrix: &Self::Matrix, factor: T, other: &Self::Matrix) -> Self::Matrix;
    /// One entry of a matrix; `None` beyond the modes.
    fn entry(matrix: &Self::Matrix, row: usize, column: usize) -> Option<T>;
    /// The entries of a matrix, row after row. Shape: M x M.
    fn entries_mut(matrix: &mut Self::Matrix) -> &mut [T];
    /// The matrix with these numbers on its diagonal. Shape: M x M.
    fn diagonal_matrix(&self) -> Self::Matrix;
    /// Factors of `matrix`, or `None` if it is not positive definite.
    fn factor(matrix: &Self::Matrix) -> Option<Self::Factors>;
    /// The solution of the factored matrix times x = `right`. Shape: M.
    fn solve(factors: &Self::Factors, right: &Self) -> Self;
    /// Zeros, six for each number here. Shape: M x 6.
    fn zero_sixes(&self) -> Self::Sixes;
    /// Solves with six right-hand sides in place. Shape: M x 6.
    fn solve_sixes(factors: &Self::Factors, right: &mut Self::Sixes);

    /// Zeros, as many as here.
    fn zeros_alike(&self) -> Self {
        let mut zeros = self.clone();
        for entry in zeros.as_mut_slice() {
            *entry = T::zero();
        }
        zeros
    }

    /// Adds `factor * other`.
    fn add_scaled(&mut self, factor: T, other: &Self) {
        for (entry, other) in self.as_mut_slice().iter_mut().zip(other.as_slice()) {
            *entry += factor * *other;
        }
    }

    /// Multiplies every number by `factor`.
    fn scale(&mut self, factor: T) {
        for entry in self.as_mut_slice() {
            *entry *= factor;
        }
    }

    /// Scalar product.
    fn dot(&self, other: &Self) -> T {
        let pairs = self.as_slice().iter().zip(other.as_slice());
        pairs.fold(T::zero(), |sum, (left, right)| sum + *left * *right)
    }

    /// The products entry by entry.
    fn times(&self, other: &Self) -> Self {
        let mut result = self.clone();
        for (entry, other) in result.as_mut_slice().iter_mut().zip(other.as_slice()) {
            *entry *= *other;
        }
        result
    }

    /// The largest absolute value; zero without modes.
    fn largest(&self) -> T {
        self.as_slice().iter().fold(T::zero(), |largest, entry| largest.max(entry.abs()))
    }

    /// Whether every number is finite.
    fn all_finite(&self) -> bool {
        self.as_slice().iter().all(|entry| entry.is_finite())
    }
}

impl<const M: usize, T: RealField + Copy> ModalVector<T> for SVector<T, M> {
    type Matrix = SMatrix<T, M, M>;
    type Factors = Cholesky<T, Const<M>>;
    type Sixes = [[T; 6]; M];

    #[inline(always)]
    fn as_slice(&self) -> &[T] {
        let [column] = &self.data.0;
        column
    }

    #[inline(always)]
    fn as_mut_slice(&mut self) -> &mut [T] {
        let [column] = &mut self.data.0;
        column
    }

    #[inline(always)]
    fn product(matrix: &Self::Matrix, vector: &Self) -> Self {
        matrix * vector
    }

    #[inline(always)]
    fn combination(matrix: &Self::Matrix, factor: T, other: &Self::Matrix) -> Self::Matrix {
        matrix + other * factor
    }

    #[inline(always)]
    fn entry(matrix: &Self::Matrix, row: usize, column: usize) -> Option<T> {
        matrix.get((row, column)).copied()
    }

    #[inline(always)]
    fn entries_mut(matrix: &mut Self::Matrix) -> &mut [T] {
        // column after column: it is symmetric
        matrix.as_mut_slice()
    }

    #[inline(always)]
    fn diagonal_matrix(&self) -> Self::Matrix {
        let mut matrix = SMatrix::zeros();
        for (k, (column, entry)) in matrix.data.0.iter_mut().zip(self.as_slice()).enumerate() {
            if let Some(place) = column.get_mut(k) {
                *place = *entry;
            }
        }
        matrix
    }

    fn factor(matrix: &Self::Matrix) -> Option<Self::Factors> {
        Cholesky::new(*matrix)
    }

    fn solve(factors: &Self::Factors, right: &Self) -> Self {
        factors.solve(right)
    }

    #[inline(always)]
    fn zero_sixes(&self) -> Self::Sixes {
        [[T::zero(); 6]; M]
    }

    fn solve_sixes(factors: &Self::Factors, right: &mut Self::Sixes) {
        for column in 0..6 {
            let mut solution = Self::zeros();
            gather(right, column, &mut solution.data.0[0]);
            factors.solve_mut(&mut solution);
            scatter(&solution.data.0[0], column, right);
        }
    }
}

/// Takes one of the six numbers of each mode.
pub(crate) fn gather<T: Copy>(sixes: &[[T; 6]], column: usize, to: &mut [T]) {
    for (place, six) in to.iter_mut().zip(sixes) {
        if let Some(number) = six.get(column) {
            *place = *number;
        }
    }
}

/// Puts one of the six numbers of each mode.
pub(crate) fn scatter<T: Copy>(numbers: &[T], column: usize, to: &mut [[T; 6]]) {
    for (number, six) in numbers.iter().zip(to) {
        if let Some(place) = six.get_mut(column) {
            *place = *number;
        }
    }
}
