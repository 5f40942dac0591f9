//! A marker at both ends of a step, for force elements that do exactly the work of their stored energy.

use nalgebra::{RealField, UnitQuaternion};

use super::MarkerMotion;

/// A marker over a step of the energy-momentum method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarkerStep<T: RealField + Copy = f64> {
    /// At the beginning and at the end.
    pub ends: [MarkerMotion<T>; 2],
    /// Means of both: place, and axes that are no triad; velocities are displacement and rotation vector (of the Cayley map)
    /// over the step. With θ that vector times the step, products of two factors change by what their means say:
    /// Δ(a · b) = ā · Δb + Δa · b̄, and Δa = θ × ā for an axis a of the triad.
    pub mean: MarkerMotion<T>,
    /// The step. Units: s.
    pub step: T,
}

impl<T: RealField + Copy> MarkerStep<T> {
    /// A place that never moves.
    pub fn still(place: MarkerMotion<T>, step: T) -> Self {
        Self { ends: [place; 2], mean: place, step }
    }

    /// The same step of a triad that is turned in this one.
    #[must_use]
    pub fn turned(self, orientation: &UnitQuaternion<T>) -> Self {
        Self {
            ends: self.ends.map(|end| end.turned(orientation)),
            mean: self.mean.turned(orientation),
            step: self.step,
        }
    }
}
