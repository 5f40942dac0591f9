//! The state of a flexible body: where it is, how it is deformed, how both change.

use nalgebra::{Quaternion, RealField, UnitQuaternion, Vector3};

use super::{FlexibleBody, ModalVector, Motion};
use crate::rotation::turned;

/// Position, orientation, deformation and their rates; `V` is the body's [`FlexibleBody::Modal`].
///
/// The velocity is that of the frame origin in *inertial* components (momentum is then a plain sum and free
/// fall is exact), the angular velocity is in *body* components (as the kernels want it).
/// See [`rotation`](crate::rotation) for the convention of the orientation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State<V, T: RealField + Copy = f64> {
    /// Position p of the frame origin. Shape: 3. Units: m. Frame: inertial.
    pub position: Vector3<T>,
    /// Orientation θ of the body frame; maps body to inertial components. Units: 1.
    pub orientation: UnitQuaternion<T>,
    /// Modal coordinates q. Shape: M. Units: those of the modes.
    pub modal_coordinates: V,
    /// Velocity ṗ of the frame origin. Shape: 3. Units: m/s. Frame: inertial.
    pub velocity: Vector3<T>,
    /// Angular velocity ω of the body frame. Shape: 3. Units: rad/s. Frame: body.
    pub angular_velocity: Vector3<T>,
    /// Rates q̇ of the modal coordinates. Shape: M. Units: those of the modes per second.
    pub modal_rates: V,
}

impl<V: ModalVector<T>, T: RealField + Copy> State<V, T> {
    /// At rest at the inertial origin, undeformed, body frame parallel to the inertial frame.
    pub fn at_rest<B: FlexibleBody<T, Modal = V>>(body: &B) -> Self {
        Self {
            position: Vector3::zeros(),
            orientation: UnitQuaternion::identity(),
            modal_coordinates: body.undeformed(),
            velocity: Vector3::zeros(),
            angular_velocity: Vector3::zeros(),
            modal_rates: body.undeformed(),
        }
    }

    /// v = Aᵀ ṗ, the velocity of the frame origin as the kernels want it. Shape: 3. Units: m/s. Frame: body.
    #[inline]
    pub fn body_velocity(&self) -> Vector3<T> {
        self.to_body(&self.velocity)
    }

    /// The velocities v, ω, q̇. Frame: body.
    pub fn velocities(&self) -> Motion<V, T> {
        Motion {
            linear: self.body_velocity(),
            angular: self.angular_velocity,
            modal: self.modal_rates.clone(),
        }
    }

    /// Components of an inertial vector in the body frame, Aᵀ u. Shape: 3.
    #[inline]
    pub fn to_body(&self, inertial: &Vector3<T>) -> Vector3<T> {
        self.orientation.inverse_transform_vector(inertial)
    }

    /// Components of a body-fixed vector in the inertial frame, A u. Shape: 3.
    #[inline]
    pub fn to_inertial(&self, body: &Vector3<T>) -> Vector3<T> {
        self.orientation.transform_vector(body)
    }

    /// Moves position, orientation and deformation by a small `step` in the body frame; rates stay.
    ///
    /// The rotation is composed by the Cayley map, see [`turned`].
    pub fn displace(&mut self, step: &Motion<V, T>) {
        self.position += self.to_inertial(&step.linear);
        self.orientation = turned(&self.orientation, &step.angular);
        self.modal_coordinates.add_scaled(T::one(), &step.modal);
    }

    /// Adds a small `change` (body frame) to the velocities v, ω, q̇.
    pub fn push(&mut self, change: &Motion<V, T>) {
        self.velocity += self.to_inertial(&change.linear);
        self.angular_velocity += change.angular;
        self.modal_rates.add_scaled(T::one(), &change.modal);
    }

    /// The numbers of the state: position, orientation (scalar first), modal coordinates, velocity, angular velocity,
    /// modal rates. Shape: 13 + 2 M.
    pub fn numbers(&self) -> impl Iterator<Item = T> {
        let [x, y, z, w]: [T; 4] = self.orientation.coords.into();
        let velocities = self.velocity.iter().chain(self.angular_velocity.iter());
        let velocities = velocities.chain(self.modal_rates.as_slice());
        let modal = self.modal_coordinates.as_slice().iter();
        let place = self.position.iter().copied().chain([w, x, y, z]).chain(modal.copied());
        place.chain(velocities.copied())
    }

    /// Takes the numbers of a state as [`numbers`](Self::numbers) gives them, bit by bit; what is missing stays as it is.
    ///
    /// The orientation must be a unit quaternion.
    pub fn set_numbers(&mut self, numbers: &mut impl Iterator<Item = T>) {
        let [x, y, z, w]: [T; 4] = self.orientation.coords.into();
        let mut orientation = [w, x, y, z];
        let mut take = |places: &mut [T]| {
            for (place, number) in places.iter_mut().zip(&mut *numbers) {
                *place = number;
            }
        };
        take(self.position.as_mut_slice());
        take(&mut orientation);
        take(self.modal_coordinates.as_mut_slice());
        take(self.velocity.as_mut_slice());
        take(self.angular_velocity.as_mut_slice());
        take(self.modal_rates.as_mut_slice());
        let [w, x, y, z] = orientation;
        self.orientation = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    }

    /// Whether every number of the state is finite, and its orientation is one: a turn so large that the squares of its quaternion
    /// leave the number type is normalised to nothing.
    pub fn is_finite(&self) -> bool {
        let finite = |x: &T| x.is_finite();
        self.position.iter().all(finite)
            && self.orientation.coords.iter().all(finite)
            && self.orientation.coords.iter().any(|x| *x != T::zero())
            && self.modal_coordinates.all_finite()
            && self.velocity.iter().all(finite)
            && self.angular_velocity.iter().all(finite)
            && self.modal_rates.all_finite()
    }
}
