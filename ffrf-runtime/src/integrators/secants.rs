//! Anderson's acceleration of depth eight, whose differences of sweeps are kept from step to step.
//!
//! Two sweeps over the stages of a step differ in where they have led to by ΔG and in what they have changed by ΔF. If the map of a
//! sweep is linear, the rates that no sweep changes are g - ΔG γ with ΔF γ = f, for a sweep that has changed f and led to g. γ is
//! that of the least ‖f - ΔF γ‖. What a sweep leaves hardly changes from one step to the next of the same size, and so the pairs
//! (ΔF, ΔG) of steps before serve the first sweeps of a step; they change how fast sweeps converge, not what to.
//!
//! The norm is that of all components in units of their own, without the sizes in a state: products of pairs stay what they are.
//!
//! Source: Walker, Ni, Anderson acceleration for fixed-point iterations, SIAM J. Numer. Anal. 49 (2011) 1715-1735.

use nalgebra::RealField;

use super::VectorSpace;

/// Most pairs that are kept. Of the rotor of `benches/peers/mechanisms` four take 5 to 20 per cent more corrections.
const DEPTH: usize = 8;

/// What a sweep is seen by: its changes of the end of the step and, times the step, of the rates of the last stage.
type Seen<I> = [I; 2];

/// The difference of two sweeps of a step, over the norm of `seen`.
#[derive(Debug, Clone)]
struct Secant<I, const S: usize> {
    seen: Seen<I>,
    rates: [I; S],
}

/// The newest differences of sweeps over `S` stages.
#[derive(Debug, Clone)]
pub(super) struct Secants<I, const S: usize, T> {
    pairs: [Option<Secant<I, S>>; DEPTH],
    /// The places of `pairs`, the newest first.
    order: [usize; DEPTH],
    /// The inner products of what `pairs` are seen by, at their places.
    products: [[T; DEPTH]; DEPTH],
}

/// What a sweep has led to.
pub(super) struct Swept<I, const S: usize, T> {
    seen: Seen<I>,
    rates: [I; S],
    /// The norm of `seen`.
    size: T,
    /// The inner products with the pairs, at their places.
    products: [T; DEPTH],
}

/// What the pairs say of the next sweep.
pub(super) struct Mixture<I, const S: usize, T> {
    /// The rates to begin it with.
    pub rates: [I; S],
    /// The share of what the last sweep has changed that the pairs do not explain, from 0 to 1. Units: 1.
    pub unexplained: T,
}

impl<I: VectorSpace<T>, T: RealField + Copy, const S: usize> Secants<I, S, T> {
    /// No pairs.
    pub fn new() -> Self {
        Self {
            pairs: core::array::from_fn(|_| None),
            order: core::array::from_fn(|place| place),
            products: [[T::zero(); DEPTH]; DEPTH],
        }
    }

    /// What a sweep has led to.
    pub fn swept(&self, seen: Seen<I>, rates: [I; S]) -> Swept<I, S, T> {
        let size = inner(&seen, &seen).sqrt();
        let mut products = [T::zero(); DEPTH];
        for (product, pair) in products.iter_mut().zip(&self.pairs) {
            if let Some(pair) = pair {
                *product = inner(&pair.seen, &seen);
            }
        }
        Swept { seen, rates, size, products }
    }

    /// Takes the difference of `now` to the sweep `before` it in place of the oldest pair.
    pub fn add(&mut self, before: Swept<I, S, T>, now: &mut Swept<I, S, T>) {
        let Swept { mut seen, mut rates, products, .. } = before;
        for (mine, other) in seen.iter_mut().chain(&mut rates).zip(now.seen.iter().chain(&now.rates)) {
            mine.add_scaled(-T::one(), other);
        }
        let size = inner(&seen, &seen).sqrt();
        if size <= T::zero() || !size.is_finite() {
            return;
        }
        for mine in seen.iter_mut().chain(&mut rates) {
            mine.scale(T::one() / size);
        }
        self.order.rotate_right(1);
        let place = at(&self.order, 0, 0);
        let mut row: [T; DEPTH] = core::array::from_fn(|other| {
            (at(&products, other, T::zero()) - at(&now.products, other, T::zero())) / size
        });
        if let Some(own) = row.get_mut(place) {
            *own = T::one();
        }
        for (others, product) in self.products.iter_mut().zip(&row) {
            if let Some(other) = others.get_mut(place) {
                *other = *product;
            }
        }
        if let Some(product) = now.products.get_mut(place) {
            *product = inner(&seen, &now.seen);
        }
        if let (Some(own), Some(pair)) = (self.products.get_mut(place), self.pairs.get_mut(place)) {
            *own = row;
            *pair = Some(Secant { seen, rates });
        }
    }

    /// What the pairs say of the sweep after `now`; nothing if there are none.
    pub fn mixed(&self, now: &Swept<I, S, T>) -> Option<Mixture<I, S, T>> {
        let zero = T::zero();
        if now.size <= zero || self.pairs.iter().all(Option::is_none) {
            return None;
        }
        let (factors, rest) = self.least_squares(now);
        let mut rates = now.rates.clone();
        for (place, factor) in self.order.iter().zip(&factors) {
            if let Some(Some(pair)) = self.pairs.get(*place)
                && *factor != zero
            {
                for (rate, other) in rates.iter_mut().zip(&pair.rates) {
                    rate.add_scaled(-*factor, other);
                }
            }
        }
        Some(Mixture { rates, unexplained: rest.max(zero).sqrt() / now.size })
    }

    /// γ, the newest first, and the square of what is left: Cholesky's factors of the normal equations, without pairs that newer ones
    /// leave less of than 1e4 roundings of, squared.
    fn least_squares(&self, now: &Swept<I, S, T>) -> ([T; DEPTH], T) {
        let zero = T::zero();
        let sum = |first: &[T], second: &[T], count: usize| {
            first.iter().zip(second).take(count).fold(zero, |sum, (one, other)| sum + *one * *other)
        };
        let least = T::default_epsilon() * nalgebra::convert(1e4);
        let (mut lower, mut right) = ([[zero; DEPTH]; DEPTH], [zero; DEPTH]);
        for (index, place) in self.order.iter().enumerate() {
            let (Some(products), Some(Some(_))) = (self.products.get(*place), self.pairs.get(*place)) else {
                continue;
            };
            let mut row = [zero; DEPTH];
            for (column, (above, other)) in lower.iter().zip(&self.order).take(index).enumerate() {
                let pivot = at(above, column, zero);
                if pivot > zero {
                    let found = (at(products, *other, zero) - sum(&row, above, column)) / pivot;
                    if let Some(entry) = row.get_mut(column) {
                        *entry = found;
                    }
                }
            }
            let left = T::one() - sum(&row, &row, index);
            if left <= least {
                continue;
            }
            let pivot = left.sqrt();
            let known = (at(&now.products, *place, zero) - sum(&row, &right, index)) / pivot;
            if let (Some(entry), Some(value), Some(own)) =
                (row.get_mut(index), right.get_mut(index), lower.get_mut(index))
            {
                (*entry, *value) = (pivot, known);
                *own = row;
            }
        }
        let rest = now.size * now.size - sum(&right, &right, DEPTH);
        let mut factors = right;
        for index in (0..DEPTH).rev() {
            let Some(row) = lower.get(index) else { continue };
            let pivot = at(row, index, zero);
            let factor = if pivot > zero { at(&factors, index, zero) / pivot } else { zero };
            for (value, entry) in factors.iter_mut().zip(row).take(index) {
                *value -= *entry * factor;
            }
            if let Some(value) = factors.get_mut(index) {
                *value = factor;
            }
        }
        (factors, rest)
    }
}

/// The number at a place, or `other` where there is none.
fn at<N: Copy>(numbers: &[N], place: usize, other: N) -> N {
    numbers.get(place).copied().unwrap_or(other)
}

/// The inner product.
fn inner<I: VectorSpace<T>, T: RealField + Copy>(first: &Seen<I>, second: &Seen<I>) -> T {
    first.iter().zip(second).fold(T::zero(), |sum, (first, second)| sum + first.dot(second))
}
