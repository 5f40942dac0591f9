//! A change of the state of a body as a vector: what stages of integrators are sums of.

use nalgebra::{RealField, Vector3};

use super::{FlexibleBody, GeneralisedForce, ModalVector, Motion, State};
use crate::integrators::{LocalError, Tolerances};
use crate::rotation::{cayley_rate, turned};

/// A change of a [`State`], or the rate of one, in the chart about that state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Increment<V, T = f64> {
    /// Of the position. Shape: 3. Units: m. Frame: inertial.
    pub position: Vector3<T>,
    /// Rotation vector of the [`cayley`](crate::rotation::cayley) map that follows the orientation. Shape: 3. Units: rad. Frame: body.
    pub rotation: Vector3<T>,
    /// Of the modal coordinates. Shape: M.
    pub modal_coordinates: V,
    /// Of the velocity. Shape: 3. Units: m/s. Frame: inertial.
    pub velocity: Vector3<T>,
    /// Of the angular velocity. Shape: 3. Units: rad/s. Frame: body.
    pub angular_velocity: Vector3<T>,
    /// Of the modal rates. Shape: M.
    pub modal_rates: V,
}

impl<V: ModalVector<T>, T: RealField + Copy> Increment<V, T> {
    /// No change, of a body with as many modes as `alike`.
    pub fn zeros(alike: &V) -> Self {
        Self {
            position: Vector3::zeros(),
            rotation: Vector3::zeros(),
            modal_coordinates: alike.zeros_alike(),
            velocity: Vector3::zeros(),
            angular_velocity: Vector3::zeros(),
            modal_rates: alike.zeros_alike(),
        }
    }

    /// Adds `factor * other`.
    #[inline]
    pub fn add_scaled(&mut self, factor: T, other: &Self) {
        self.position += other.position * factor;
        self.rotation += other.rotation * factor;
        self.modal_coordinates.add_scaled(factor, &other.modal_coordinates);
        self.velocity += other.velocity * factor;
        self.angular_velocity += other.angular_velocity * factor;
        self.modal_rates.add_scaled(factor, &other.modal_rates);
    }

    /// Multiplies by `factor`.
    #[inline]
    pub fn scale(&mut self, factor: T) {
        self.position *= factor;
        self.rotation *= factor;
        self.modal_coordinates.scale(factor);
        self.velocity *= factor;
        self.angular_velocity *= factor;
        self.modal_rates.scale(factor);
    }

    /// The sum of the products of all components, each in its own unit.
    #[inline]
    pub fn dot(&self, other: &Self) -> T {
        self.position.dot(&other.position)
            + self.rotation.dot(&other.rotation)
            + self.modal_coordinates.dot(&other.modal_coordinates)
            + self.velocity.dot(&other.velocity)
            + self.angular_velocity.dot(&other.angular_velocity)
            + self.modal_rates.dot(&other.modal_rates)
    }

    /// The rate of the place alone when this increment has led to `state`; rates of velocities zero.
    pub fn place_rate(&self, state: &State<V, T>) -> Self {
        self.rate(state, Motion::zeros(&state.modal_rates))
    }

    /// The change of the places alone.
    pub(crate) fn places_only(&self) -> Self {
        Self {
            velocity: Vector3::zeros(),
            angular_velocity: Vector3::zeros(),
            modal_rates: self.modal_rates.zeros_alike(),
            ..self.clone()
        }
    }

    /// The change of the velocities alone.
    pub fn velocities_only(&self) -> Self {
        Self {
            position: Vector3::zeros(),
            rotation: Vector3::zeros(),
            modal_coordinates: self.modal_coordinates.zeros_alike(),
            ..self.clone()
        }
    }

    /// The rate of this increment when it has led to `state`, which then has `accelerations`.
    #[inline]
    pub fn rate(&self, state: &State<V, T>, accelerations: Motion<V, T>) -> Self {
        Self {
            position: state.velocity,
            rotation: cayley_rate(&self.rotation, &state.angular_velocity),
            modal_coordinates: state.modal_rates.clone(),
            velocity: state.to_inertial(&accelerations.linear),
            angular_velocity: accelerations.angular,
            modal_rates: accelerations.modal,
        }
    }
}

impl<V: ModalVector<T>, T: RealField + Copy> Increment<V, T> {
    /// [`rate`](Self::rate) of a free body under `force`.
    #[inline]
    pub(crate) fn rate_under<B: FlexibleBody<T, Modal = V>>(
        &self,
        body: &B,
        state: &State<V, T>,
        force: &GeneralisedForce<V, T>,
    ) -> Self {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = state;
        self.rate(state, body.forward_dynamics(modal_coordinates, angular_velocity, modal_rates, force))
    }
}

impl<V: ModalVector<T>, T: RealField + Copy> State<V, T> {
    /// The state that an increment leads to.
    #[inline]
    pub fn retract(&self, increment: &Increment<V, T>) -> Self {
        // number by number: a copy of the whole to change would be made in memory
        let plus = |vector: &V, change: &V| {
            let mut sum = vector.clone();
            sum.add_scaled(T::one(), change);
            sum
        };
        Self {
            position: self.position + increment.position,
            orientation: turned(&self.orientation, &increment.rotation),
            modal_coordinates: plus(&self.modal_coordinates, &increment.modal_coordinates),
            velocity: self.velocity + increment.velocity,
            angular_velocity: self.angular_velocity + increment.angular_velocity,
            modal_rates: plus(&self.modal_rates, &increment.modal_rates),
        }
    }
}

impl<V: ModalVector<T>, T: RealField + Copy> Increment<V, T> {
    /// The largest component of each kind of place.
    pub fn local_error(&self) -> LocalError<T> {
        LocalError {
            position: self.position.amax(),
            orientation: self.rotation.amax(),
            modal_coordinates: self.modal_coordinates.largest(),
        }
    }

    /// The sum of squares of every component over its tolerance in `state`, and their number.
    ///
    /// Rotations are measured against the absolute tolerance and one radian.
    pub fn weighted_squares(&self, state: &State<V, T>, tolerances: &Tolerances<T>) -> (T, T) {
        let mut squares = (T::zero(), T::zero());
        let mut add = |differences: &[T], sizes: &[T]| {
            for (difference, size) in differences.iter().zip(sizes) {
                let ratio = *difference / (tolerances.absolute + tolerances.relative * size.abs());
                squares.0 += ratio * ratio;
                squares.1 += T::one();
            }
        };
        add(self.position.as_slice(), state.position.as_slice());
        add(self.rotation.as_slice(), &[T::one(); 3]);
        add(self.modal_coordinates.as_slice(), state.modal_coordinates.as_slice());
        add(self.velocity.as_slice(), state.velocity.as_slice());
        add(self.angular_velocity.as_slice(), state.angular_velocity.as_slice());
        add(self.modal_rates.as_slice(), state.modal_rates.as_slice());
        squares
    }
}
