//! Products of matrices over the modes.

use super::scalar::{Register, four};
use super::{Lanes, ModalMatrix, Scalar};

impl<C: Copy, const M: usize, const G: usize> ModalMatrix<'_, C, M, G> {
    /// One group of the products with `K` vectors, which are given by this group and as a whole.
    #[inline(always)]
    pub(super) fn products<T: Scalar<Constant = C>, const K: usize>(
        &self,
        group: usize,
        lanes: [Register<T>; K],
        vectors: [&[[T; 4]; G]; K],
    ) -> [Register<T>; K] {
        match self {
            Self::Zero => [Register::<T>::zero(); K],
            Self::Identity => lanes,
            Self::Diagonal(entries) => lanes.map(|lanes| four::<T>(&entries[group]) * lanes),
            Self::Dense(entries) => {
                let mut sums = [Register::<T>::zero(); K];
                let vectors = vectors.map(|vector| vector.as_flattened());
                for (nu, column) in entries[group].iter().enumerate() {
                    let column = four::<T>(column);
                    for (sum, vector) in sums.iter_mut().zip(vectors) {
                        if let Some(entry) = vector.get(nu) {
                            *sum = column.multiply_add(Register::<T>::splat(*entry), *sum);
                        }
                    }
                }
                sums
            }
        }
    }

    /// `term` less one group of the product with a vector, which is given by this group and as a whole.
    #[inline(always)]
    pub(super) fn subtract_product<T: Scalar<Constant = C>>(
        &self,
        group: usize,
        lanes: Register<T>,
        vector: &[[T; 4]; G],
        term: Register<T>,
    ) -> Register<T> {
        match self {
            Self::Zero => term,
            Self::Identity => term - lanes,
            Self::Diagonal(entries) => four::<T>(&entries[group]).subtract_from(lanes, term),
            Self::Dense(entries) => {
                let mut rest = term;
                for (column, entry) in entries[group].iter().zip(vector.as_flattened()) {
                    rest = four::<T>(column).subtract_from(Register::<T>::splat(*entry), rest);
                }
                rest
            }
        }
    }
}
