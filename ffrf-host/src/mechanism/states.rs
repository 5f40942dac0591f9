//! The increments of all bodies as one vector.

use ffrf_runtime::{Increment, VectorSpace};
use nalgebra::RealField;

use crate::HostModal;

/// A change of the states of all bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct HostIncrement<T: RealField + Copy = f64>(pub Vec<Increment<HostModal<T>, T>>);

impl<T: RealField + Copy> VectorSpace<T> for HostIncrement<T> {
    fn add_scaled(&mut self, factor: T, other: &Self) {
        for (own, other) in self.0.iter_mut().zip(&other.0) {
            own.add_scaled(factor, other);
        }
    }

    fn scale(&mut self, factor: T) {
        for own in &mut self.0 {
            own.scale(factor);
        }
    }

    fn dot(&self, other: &Self) -> T {
        self.0.iter().zip(&other.0).fold(T::zero(), |sum, (own, other)| sum + own.dot(other))
    }
}
