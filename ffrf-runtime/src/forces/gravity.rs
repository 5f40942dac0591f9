//! Uniform gravity.

use nalgebra::{RealField, Vector3};

use crate::{FlexibleBody, GeneralisedForce, Load, State};

/// Uniform gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gravity<T = f64> {
    /// Acceleration of free fall g. Shape: 3. Units: m/s². Frame: inertial.
    pub acceleration: Vector3<T>,
}

impl<B, T> Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T> for Gravity<T>
where
    B: FlexibleBody<T>,
    T: RealField + Copy,
{
    fn add_to(&self, body: &B, _: T, state: &State<B::Modal, T>, force: &mut GeneralisedForce<B::Modal, T>) {
        let weight = body.gravity_force(&state.modal_coordinates, &state.to_body(&self.acceleration));
        force.add_scaled(T::one(), &weight);
    }
}
