//! Products of matrices over the modes.

use super::groups::{Register, four, scaled, splat, zero};
use super::{Lanes, ModalMatrix, Registers, Scalar};

impl<C: Copy, const M: usize, const G: usize> ModalMatrix<'_, C, M, G> {
    /// One group of the products with `K` vectors, which are given by this group and as a whole.
    #[inline(always)]
    pub(super) fn products<T: Scalar<Constant = C>, R: Registers<T>, const K: usize>(
        &self,
        registers: R,
        group: usize,
        lanes: [Register<T, R>; K],
        vectors: [&[[T; 4]; G]; K],
    ) -> [Register<T, R>; K] {
        match self {
            Self::Zero => [zero::<T, R>(registers); K],
            Self::Identity => lanes,
            Self::Diagonal(entries) => scaled(four::<T, R>(registers, &entries[group]), lanes),
            Self::Dense(entries) => {
                let mut sums = [zero::<T, R>(registers); K];
                let vectors = vectors.map(|vector| vector.as_flattened());
                for (nu, column) in entries[group].iter().enumerate() {
                    let column = four::<T, R>(registers, column);
                    for (sum, vector) in sums.iter_mut().zip(vectors) {
                        if let Some(entry) = vector.get(nu) {
                            *sum = column.multiply_add(splat::<T, R>(registers, *entry), *sum);
                        }
                    }
                }
                sums
            }
        }
    }

    /// `term` less one group of the product with a vector, which is given by this group and as a whole.
    #[inline(always)]
    pub(super) fn subtract_product<T: Scalar<Constant = C>, R: Registers<T>>(
        &self,
        registers: R,
        group: usize,
        lanes: Register<T, R>,
        vector: &[[T; 4]; G],
        term: Register<T, R>,
    ) -> Register<T, R> {
        match self {
            Self::Zero => term,
            Self::Identity => term - lanes,
            Self::Diagonal(entries) => four::<T, R>(registers, &entries[group]).subtract_from(lanes, term),
            Self::Dense(entries) => {
                let mut rest = term;
                for (column, entry) in entries[group].iter().zip(vector.as_flattened()) {
                    rest =
                        four::<T, R>(registers, column).subtract_from(splat::<T, R>(registers, *entry), rest);
                }
                rest
            }
        }
    }
}
