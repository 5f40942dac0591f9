//! The increments of all bodies as one vector.

use ffrf_runtime::{Increment, VectorSpace};

use crate::HostModal;

/// A change of the states of all bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct HostIncrement(pub Vec<Increment<HostModal>>);

impl VectorSpace<f64> for HostIncrement {
    fn add_scaled(&mut self, factor: f64, other: &Self) {
        for (own, other) in self.0.iter_mut().zip(&other.0) {
            own.add_scaled(factor, other);
        }
    }

    fn scale(&mut self, factor: f64) {
        for own in &mut self.0 {
            own.scale(factor);
        }
    }
}
