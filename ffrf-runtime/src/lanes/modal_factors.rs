//! Triangular factors of Θ_ff.

use super::groups::{Register, four, load, scaled, splat};
use super::{Lanes, Registers, Scalar};

/// Θ_ff = L D Lᵀ with ones on the diagonal of L, in groups of four modes.
#[derive(Debug, Clone, Copy)]
pub enum ModalFactors<'a, C, const M: usize, const G: usize> {
    /// Θ_ff = I.
    Identity,
    /// L = I, and 1 / D.
    Diagonal(&'a [[C; 4]; G]),
    /// A dense Θ_ff.
    Triangular {
        /// 1 / D.
        inverse_pivots: &'a [[C; 4]; G],
        /// L + Lᵀ without its diagonal: `[group][nu][lane]`, lanes over μ. So both substitutions read whole registers.
        lower: &'a [[[C; 4]; M]; G],
    },
}

impl<C: Copy, const M: usize, const G: usize> ModalFactors<'_, C, M, G> {
    /// One group of D⁻¹ v of `K` vectors.
    #[inline(always)]
    pub(super) fn weigh<T: Scalar<Constant = C>, R: Registers<T>, const K: usize>(
        &self,
        registers: R,
        group: usize,
        lanes: [Register<T, R>; K],
    ) -> [Register<T, R>; K] {
        match self {
            Self::Identity => lanes,
            Self::Diagonal(entries) | Self::Triangular { inverse_pivots: entries, .. } => {
                scaled(four::<T, R>(registers, &entries[group]), lanes)
            }
        }
    }

    /// L⁻¹ v of `K` vectors, in place.
    #[inline(always)]
    pub(super) fn forward<T: Scalar<Constant = C>, R: Registers<T>, const K: usize>(
        &self,
        registers: R,
        vectors: &mut [[[T; 4]; G]; K],
    ) {
        let Self::Triangular { lower, .. } = self else { return };
        for group in 0..G {
            let columns = lower[group].iter().enumerate().take(4 * group);
            let mut block = Self::rest(registers, columns, group, vectors);
            for j in 0..4 {
                let Some(column) = lower[group].get(4 * group + j) else { continue };
                for i in j + 1..4 {
                    let entry = -T::constant(column[i]);
                    for vector in &mut block {
                        vector[i] = registers.multiply_add(entry, vector[j], vector[i]);
                    }
                }
            }
            for (vector, block) in vectors.iter_mut().zip(block) {
                vector[group] = block;
            }
        }
    }

    /// L⁻ᵀ v of `K` vectors, in place.
    #[inline(always)]
    pub(super) fn backward<T: Scalar<Constant = C>, R: Registers<T>, const K: usize>(
        &self,
        registers: R,
        vectors: &mut [[[T; 4]; G]; K],
    ) {
        let Self::Triangular { lower, .. } = self else { return };
        for group in (0..G).rev() {
            let columns = lower[group].iter().enumerate().skip(4 * group + 4);
            let mut block = Self::rest(registers, columns, group, vectors);
            for j in (1..4).rev() {
                let Some(column) = lower[group].get(4 * group + j) else { continue };
                for i in 0..j {
                    let entry = -T::constant(column[i]);
                    for vector in &mut block {
                        vector[i] = registers.multiply_add(entry, vector[j], vector[i]);
                    }
                }
            }
            for (vector, block) in vectors.iter_mut().zip(block) {
                vector[group] = block;
            }
        }
    }

    /// One group of each vector less the columns times the entries that are already solved for.
    #[inline(always)]
    fn rest<'b, T: Scalar<Constant = C>, R: Registers<T>, const K: usize>(
        registers: R,
        columns: impl Iterator<Item = (usize, &'b [C; 4])>,
        group: usize,
        vectors: &[[[T; 4]; G]; K],
    ) -> [[T; 4]; K]
    where
        C: 'b,
    {
        let mut rest = vectors.each_ref().map(|vector| load::<T, R>(registers, &vector[group]));
        let entries = vectors.each_ref().map(|vector| vector.as_flattened());
        for (nu, column) in columns {
            let column = four::<T, R>(registers, column);
            for (rest, entries) in rest.iter_mut().zip(entries) {
                if let Some(entry) = entries.get(nu) {
                    *rest = column.subtract_from(splat::<T, R>(registers, *entry), *rest);
                }
            }
        }
        rest.map(|lanes| lanes.store())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Compiled;
    use super::*;

    #[test]
    fn both_substitutions_undo_the_products() {
        // Six modes in two groups, the second padded.
        let entry = |mu: usize, nu: usize| 0.1 * (mu as f64 + 1.0) - 0.25 * nu as f64;
        let lower: [[[f64; 4]; 6]; 2] = core::array::from_fn(|group| {
            core::array::from_fn(|nu| {
                core::array::from_fn(|lane| {
                    let mu = 4 * group + lane;
                    if mu == nu || mu >= 6 { 0.0 } else { entry(mu.max(nu), mu.min(nu)) }
                })
            })
        });
        let pivots = [[1.0; 4]; 2];
        let factors = ModalFactors::Triangular { inverse_pivots: &pivots, lower: &lower };
        let expected = [1.0, -2.0, 3.0, 0.5, -1.5, 2.5];
        let product = |is_transposed: bool| -> [[f64; 4]; 2] {
            let mut numbers = [0.0; 8];
            for i in 0..6 {
                numbers[i] = expected[i];
                for k in if is_transposed { i + 1..6 } else { 0..i } {
                    numbers[i] += entry(i.max(k), i.min(k)) * expected[k];
                }
            }
            [[numbers[0], numbers[1], numbers[2], numbers[3]], [numbers[4], numbers[5], 0.0, 0.0]]
        };
        for is_transposed in [false, true] {
            let mut vectors = [product(is_transposed)];
            if is_transposed {
                factors.backward(Compiled, &mut vectors)
            } else {
                factors.forward(Compiled, &mut vectors)
            }
            for (found, expected) in vectors.as_flattened().as_flattened().iter().zip(expected) {
                assert!((found - expected).abs() < 1e-14, "{found}, expected {expected}");
            }
        }
    }
}
