//! What a configuration was planned for, and whether a state has left it.

use nalgebra::RealField;

use super::{ModalVector, State};
use crate::integrators::Departure;

/// The motion that the modes, terms and step of a body were chosen for.
///
/// Looking at a state costs M + 6 products, as many sums and four comparisons; no root, no division.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Envelope<T = f64> {
    /// Largest norm of the modal coordinates, √(q·q). Units: those of the modes.
    pub deformation: T,
    /// Largest velocity of the frame origin. Units: m/s.
    pub speed: T,
    /// Largest angular velocity. Units: rad/s.
    pub spin: T,
    /// First bending frequency: a body that turns faster has left the validity of linear modes, whatever was planned.
    /// Units: rad/s.
    pub bending: T,
}

impl<T: RealField + Copy> Envelope<T> {
    /// What the state of a body has left.
    pub fn departure<V: ModalVector<T>>(&self, state: &State<V, T>) -> Departure {
        let q = &state.modal_coordinates;
        let (spin, speed) = (state.angular_velocity.norm_squared(), state.velocity.norm_squared());
        // what is not a number is outside
        let beyond = |square: T, bound: T| {
            let within = square <= bound * bound;
            !within
        };
        Departure {
            deformation: beyond(q.dot(q), self.deformation),
            speed: beyond(speed, self.speed),
            spin: beyond(spin, self.spin),
            bending: beyond(spin, self.bending),
        }
    }
}
