//! Anderson's acceleration of depth one, for sweeps over the stages of a step.
//!
//! Source: Walker, Ni, Anderson acceleration for fixed-point iterations, SIAM J. Numer. Anal. 49 (2011) 1715-1735.

use nalgebra::RealField;

use super::VectorSpace;

/// What a sweep over `S` stages has led to.
pub(super) struct Sweep<I, T, const S: usize> {
    /// The rates of the stages after it.
    pub rates: [I; S],
    /// The change of the state over the step by these rates.
    pub end: I,
    /// What the sweep has changed of `end`.
    pub change: I,
    /// The size of `change`, over tolerance. Units: 1.
    pub residual: T,
}

/// What two sweeps say of the next one.
pub(super) struct Outlook<T> {
    /// The size of the error that the end has after the second, over tolerance. Units: 1.
    pub left: T,
    /// The share of the first in the mixture of both, from -1 to 1, that leaves the least change. Units: 1.
    pub share: T,
}

impl<I: VectorSpace<T>, T: RealField + Copy, const S: usize> Sweep<I, T, S> {
    /// What this sweep, which began at rates that `before` has led to or at a mixture with earlier ones, says of the next one.
    ///
    /// The map of a sweep is taken as linear: what it leaves of its own change is as much as it has left of the difference to
    /// `before`. `size`: the norm of a change of the end, that of an inner product.
    pub fn after(&self, before: &Self, size: impl Fn(&I) -> T) -> Outlook<T> {
        let less = |change: &I, other: &I| {
            let mut less = change.clone();
            less.add_scaled(-T::one(), other);
            size(&less)
        };
        let taken = less(&self.change, &before.change);
        if taken <= T::zero() {
            return Outlook { left: self.residual, share: T::zero() };
        }
        let (now, then) = (self.residual / taken, before.residual / taken);
        let least = (T::one() + (now - then) * (now + then)) * nalgebra::convert(0.5);
        Outlook { left: now * less(&self.end, &before.end), share: least.max(-T::one()).min(T::one()) }
    }

    /// The rates that the next sweep begins with, with this `share` of `before`.
    pub fn mixed(&self, before: &Self, share: T) -> [I; S] {
        let mut rates = self.rates.clone();
        for (rate, earlier) in rates.iter_mut().zip(&before.rates) {
            rate.scale(T::one() - share);
            rate.add_scaled(share, earlier);
        }
        rates
    }
}
