//! Vectors over the modes whose number is known at run time.

use ffrf_runtime::{Marker, ModalVector};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn, RealField};

/// Numbers, one for each mode.
#[derive(Debug, Clone, PartialEq)]
pub struct HostModal<T: RealField + Copy = f64>(pub DVector<T>);

impl<T: RealField + Copy> HostModal<T> {
    /// Zeros. Shape: `modes`.
    pub fn zeros(modes: usize) -> Self {
        Self(DVector::zeros(modes))
    }
}

impl HostModal {
    /// The same numbers in another type.
    pub fn cast<T: RealField + Copy>(&self) -> HostModal<T> {
        HostModal(self.0.map(nalgebra::convert))
    }

    /// A marker with its numbers in another type.
    pub(crate) fn cast_marker<T: RealField + Copy>(marker: &Marker<Self, f64>) -> Marker<HostModal<T>, T> {
        Marker {
            position: marker.position.map(nalgebra::convert),
            translation: marker.translation.each_ref().map(Self::cast),
            rotation: marker.rotation.each_ref().map(Self::cast),
            stressing: marker.stressing,
        }
    }
}

impl<T: RealField + Copy> ModalVector<T> for HostModal<T> {
    type Matrix = DMatrix<T>;
    type Factors = Cholesky<T, Dyn>;
    type Sixes = Vec<[T; 6]>;

    fn as_slice(&self) -> &[T] {
        self.0.as_slice()
    }

    fn as_mut_slice(&mut self) -> &mut [T] {
        self.0.as_mut_slice()
    }

    fn product(matrix: &Self::Matrix, vector: &Self) -> Self {
        Self(matrix * &vector.0)
    }

    fn combination(matrix: &Self::Matrix, factor: T, other: &Self::Matrix) -> Self::Matrix {
        matrix + other * factor
    }

    fn entry(matrix: &Self::Matrix, row: usize, column: usize) -> Option<T> {
        matrix.get((row, column)).copied()
    }

    fn entries_mut(matrix: &mut Self::Matrix) -> &mut [T] {
        matrix.as_mut_slice()
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

    fn zero_sixes(&self) -> Self::Sixes {
        vec![[T::zero(); 6]; self.0.len()]
    }

    fn solve_sixes(factors: &Self::Factors, right: &mut Self::Sixes) {
        let mut columns = DMatrix::from_fn(right.len(), 6, |mode, column| right[mode][column]);
        factors.solve_mut(&mut columns);
        for (mode, six) in right.iter_mut().enumerate() {
            *six = core::array::from_fn(|column| columns[(mode, column)]);
        }
    }
}
