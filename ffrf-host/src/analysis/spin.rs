//! Steady rotations: the symmetry that turns a mechanism without changing its equations, as a vector field.
//!
//! A mechanism in steady rotation moves along the field X of a symmetry. Seen from there it is at rest, and its equations
//! x' = F(x) - X(x) can be linearised with constant coefficients.
//! Source: J. E. Marsden, Lectures on Mechanics (1992), chapter 4 (relative equilibria).

use ffrf_runtime::rotation::cayley_rate;
use ffrf_runtime::{Increment, State};
use nalgebra::{RealField, UnitQuaternion, Vector3, convert};

use crate::HostModal;
use crate::mechanism::HostIncrement;

/// The states of all bodies.
pub(super) type States<T = f64> = Vec<State<HostModal<T>, T>>;

/// Which symmetry carries a steady rotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpinFrame {
    /// Round bodies turn about their own axes while everything else stands: eigenvalues of the inertial frame.
    Material,
    /// The whole mechanism turns about one axis: eigenvalues of the rotating frame.
    Space,
}

/// A steady rotation.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Spin {
    /// For each body that turns, the angular velocity and a point of the axis, both in its frame.
    Material(Vec<Option<[Vector3<f64>; 2]>>),
    /// Angular velocity and a point of the axis. Frame: inertial.
    Space([Vector3<f64>; 2]),
}

impl Spin {
    /// The field in a state that `increment` has led to, as rates in the chart about where that began.
    pub(super) fn field<T: RealField + Copy>(
        &self,
        state: &States<T>,
        increment: &HostIncrement<T>,
    ) -> HostIncrement<T> {
        let cast = |vector: &Vector3<f64>| vector.map(convert::<f64, T>);
        let bodies = state.iter().zip(&increment.0).enumerate().map(|(index, (state, increment))| {
            let mut field = Increment::zeros(&state.modal_coordinates);
            match self {
                Self::Space([omega, point]) => {
                    let omega = cast(omega);
                    field.position = omega.cross(&(state.position - cast(point)));
                    field.rotation = cayley_rate(&increment.rotation, &state.to_body(&omega));
                    field.velocity = omega.cross(&state.velocity);
                }
                Self::Material(bodies) => {
                    if let Some([omega, point]) = bodies.get(index).and_then(Option::as_ref) {
                        let (omega, point) = (cast(omega), cast(point));
                        let moved = -omega.cross(&point);
                        field.position = state.to_inertial(&moved);
                        field.rotation = cayley_rate(&increment.rotation, &omega);
                        field.velocity = state.to_inertial(&state.angular_velocity.cross(&moved));
                        field.angular_velocity = -omega.cross(&state.angular_velocity);
                    }
                }
            }
            field
        });
        HostIncrement(bodies.collect())
    }

    /// Velocity and angular velocity of every body that moves along the field; modes rest.
    pub(super) fn velocities<T: RealField + Copy>(&self, state: &States<T>) -> Vec<[Vector3<T>; 2]> {
        let cast = |vector: &Vector3<f64>| vector.map(convert::<f64, T>);
        let of = |(index, state): (usize, &State<HostModal<T>, T>)| match self {
            Self::Space([omega, point]) => {
                let omega = cast(omega);
                [omega.cross(&(state.position - cast(point))), state.to_body(&omega)]
            }
            Self::Material(bodies) => match bodies.get(index).and_then(Option::as_ref) {
                Some([omega, point]) => {
                    let (omega, point) = (cast(omega), cast(point));
                    [-state.to_inertial(&omega.cross(&point)), omega]
                }
                None => [Vector3::zeros(); 2],
            },
        };
        state.iter().enumerate().map(of).collect()
    }

    /// The state after a time (s) along the field.
    pub(super) fn carried(&self, state: &States, time: f64) -> States {
        let bodies = state.iter().enumerate().map(|(index, state)| {
            let mut state = state.clone();
            match self {
                Self::Space([omega, point]) => {
                    let turn = UnitQuaternion::from_scaled_axis(omega * time);
                    state.position = point + turn * (state.position - point);
                    state.orientation = turn * state.orientation;
                    state.velocity = turn * state.velocity;
                }
                Self::Material(bodies) => {
                    if let Some([omega, point]) = bodies.get(index).and_then(Option::as_ref) {
                        let turn = UnitQuaternion::from_scaled_axis(omega * time);
                        let moved = point - turn * point;
                        state.position += state.to_inertial(&moved);
                        state.velocity += state.to_inertial(&state.angular_velocity.cross(&moved));
                        state.orientation *= turn;
                        state.angular_velocity = turn.inverse() * state.angular_velocity;
                    }
                }
            }
            state
        });
        bodies.collect()
    }
}
