//! A constant force and a constant moment at a marker, fixed in space or following the body.

use nalgebra::{RealField, Vector3};

use crate::{FlexibleBody, GeneralisedForce, Load, Marker, ModalVector, State};

/// The frame in which a force or moment keeps its components.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Frame {
    /// Constant direction in space.
    Inertial,
    /// Constant direction in the body frame: a follower force.
    Body,
}

/// A constant force and a constant moment at a marker.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarkerLoad<V, T = f64> {
    /// Where the load acts.
    pub marker: Marker<V, T>,
    /// Force. Shape: 3. Units: N. Frame: `frame`.
    pub force: Vector3<T>,
    /// Moment. Shape: 3. Units: N m. Frame: `frame`.
    pub moment: Vector3<T>,
    /// The frame of both.
    pub frame: Frame,
}

impl<V: ModalVector<T>, T: RealField + Copy> MarkerLoad<V, T> {
    /// A force at `marker`, in N.
    pub fn force(marker: Marker<V, T>, force: Vector3<T>, frame: Frame) -> Self {
        Self { marker, force, moment: Vector3::zeros(), frame }
    }

    /// A moment at `marker`, in N m.
    pub fn moment(marker: Marker<V, T>, moment: Vector3<T>, frame: Frame) -> Self {
        Self { marker, force: Vector3::zeros(), moment, frame }
    }
}

impl<B, T> Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T> for MarkerLoad<B::Modal, T>
where
    B: FlexibleBody<T>,
    T: RealField + Copy,
{
    fn add_to(&self, _: &B, _: T, state: &State<B::Modal, T>, force: &mut GeneralisedForce<B::Modal, T>) {
        let (marker_force, moment) = match self.frame {
            Frame::Inertial => (state.to_body(&self.force), state.to_body(&self.moment)),
            Frame::Body => (self.force, self.moment),
        };
        let q = &state.modal_coordinates;
        force.add_scaled(T::one(), &self.marker.force(q, &marker_force));
        force.add_scaled(T::one(), &self.marker.moment(q, &moment));
    }
}
