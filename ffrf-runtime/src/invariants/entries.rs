//! Fields as numbers: arrays of arrays, in single or double precision, whole or their diagonals only.

use super::InvariantIndex;

/// Numbers with their indices.
pub trait Entries {
    /// Distance of the number type's numbers next to 1.
    const EPSILON: f64;
    /// The first number that is not finite, below `index`.
    fn non_finite(&self, index: InvariantIndex) -> Option<(InvariantIndex, f64)>;
}

impl Entries for f64 {
    const EPSILON: f64 = f64::EPSILON;
    fn non_finite(&self, index: InvariantIndex) -> Option<(InvariantIndex, f64)> {
        (!self.is_finite()).then_some((index, *self))
    }
}

impl Entries for f32 {
    const EPSILON: f64 = f32::EPSILON as f64;
    fn non_finite(&self, index: InvariantIndex) -> Option<(InvariantIndex, f64)> {
        (!self.is_finite()).then_some((index, f64::from(*self)))
    }
}

impl<E: Entries, const R: usize> Entries for [E; R] {
    const EPSILON: f64 = E::EPSILON;
    fn non_finite(&self, index: InvariantIndex) -> Option<(InvariantIndex, f64)> {
        self.iter().enumerate().find_map(|(k, entry)| entry.non_finite(index.then(k)))
    }
}

/// A square matrix. Shape: R x R.
pub trait Square<const R: usize>: Entries {
    /// The entry in row `i` and column `j`.
    fn at(&self, i: usize, j: usize) -> f64;
    /// Where that entry stands, below `index`.
    fn place(&self, index: InvariantIndex, i: usize, j: usize) -> InvariantIndex;
}

macro_rules! square {
    ($scalar:ty) => {
        impl<const R: usize> Square<R> for [[$scalar; R]; R] {
            fn at(&self, i: usize, j: usize) -> f64 {
                self[i][j].into()
            }
            fn place(&self, index: InvariantIndex, i: usize, j: usize) -> InvariantIndex {
                index.then(i).then(j)
            }
        }

        /// A diagonal matrix.
        impl<const R: usize> Square<R> for [$scalar; R] {
            fn at(&self, i: usize, j: usize) -> f64 {
                if i == j { self[i].into() } else { 0.0 }
            }
            fn place(&self, index: InvariantIndex, i: usize, _: usize) -> InvariantIndex {
                index.then(i)
            }
        }
    };
}

square!(f32);
square!(f64);
