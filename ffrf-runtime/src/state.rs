//! The state of a flexible body: where it is, how it is deformed, how both change.

use nalgebra::{RealField, SVector, UnitQuaternion, Vector3};

/// Position, orientation, deformation and their rates, for a body with `M` modes.
///
/// The velocity is that of the frame origin in *inertial* components (momentum is then a plain sum and free
/// fall is exact), the angular velocity is in *body* components (as the kernels want it).
/// See [`rotation`](crate::rotation) for the convention of the orientation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State<const M: usize, T: RealField + Copy = f64> {
    /// Position p of the frame origin. Shape: 3. Units: m. Frame: inertial.
    pub position: Vector3<T>,
    /// Orientation θ of the body frame; maps body to inertial components. Units: 1.
    pub orientation: UnitQuaternion<T>,
    /// Modal coordinates q. Shape: M. Units: those of the modes.
    pub modal_coordinates: SVector<T, M>,
    /// Velocity ṗ of the frame origin. Shape: 3. Units: m/s. Frame: inertial.
    pub velocity: Vector3<T>,
    /// Angular velocity ω of the body frame. Shape: 3. Units: rad/s. Frame: body.
    pub angular_velocity: Vector3<T>,
    /// Rates q̇ of the modal coordinates. Shape: M. Units: those of the modes per second.
    pub modal_rates: SVector<T, M>,
}

impl<const M: usize, T: RealField + Copy> State<M, T> {
    /// At rest at the inertial origin, undeformed, body frame parallel to the inertial frame.
    pub fn at_rest() -> Self {
        Self {
            position: Vector3::zeros(),
            orientation: UnitQuaternion::identity(),
            modal_coordinates: SVector::zeros(),
            velocity: Vector3::zeros(),
            angular_velocity: Vector3::zeros(),
            modal_rates: SVector::zeros(),
        }
    }

    /// v = Aᵀ ṗ, the velocity of the frame origin as the kernels want it.
    ///
    /// Shape: 3. Units: m/s. Frame: body. Panics: never.
    pub fn body_velocity(&self) -> Vector3<T> {
        self.to_body(&self.velocity)
    }

    /// Components of an inertial vector in the body frame, Aᵀ u. Shape: 3. Panics: never.
    pub fn to_body(&self, inertial: &Vector3<T>) -> Vector3<T> {
        self.orientation.inverse_transform_vector(inertial)
    }

    /// Components of a body-fixed vector in the inertial frame, A u. Shape: 3. Panics: never.
    pub fn to_inertial(&self, body: &Vector3<T>) -> Vector3<T> {
        self.orientation.transform_vector(body)
    }

    /// Whether every number of the state is finite.
    pub fn is_finite(&self) -> bool {
        let finite = |x: &T| x.is_finite();
        self.position.iter().all(finite)
            && self.orientation.coords.iter().all(finite)
            && self.modal_coordinates.iter().all(finite)
            && self.velocity.iter().all(finite)
            && self.angular_velocity.iter().all(finite)
            && self.modal_rates.iter().all(finite)
    }
}

impl<const M: usize, T: RealField + Copy> Default for State<M, T> {
    fn default() -> Self {
        Self::at_rest()
    }
}
