//! Joints with what they connect.

use nalgebra::{RealField, UnitQuaternion, Vector3};

use super::Ports;
use crate::body::{MarkerMotion, MarkerStep};
use crate::joints::JointKind;

/// One end of a joint, force element or sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attachment<T: RealField + Copy = f64> {
    /// The body, or `None` for the ground.
    pub body: Option<usize>,
    /// The marker of that body.
    pub marker: usize,
    /// Position on the ground. Shape: 3. Units: m. Frame: inertial. Of no effect on bodies: that is the marker's.
    pub position: Vector3<T>,
    /// Orientation of the attached triad in that of the marker, or of the ground. The joint's axis is its z axis.
    pub orientation: UnitQuaternion<T>,
}

impl<T: RealField + Copy> Attachment<T> {
    /// A triad on the ground. Units: m. Frame: inertial.
    pub fn on_ground(position: Vector3<T>, orientation: UnitQuaternion<T>) -> Self {
        Self { body: None, marker: 0, position, orientation }
    }

    /// A triad at a marker of a body, with this orientation in that of the marker.
    pub fn on_body(body: usize, marker: usize, orientation: UnitQuaternion<T>) -> Self {
        Self { body: Some(body), marker, position: Vector3::zeros(), orientation }
    }

    /// Place and motion of the attached triad.
    pub fn motion(&self, ports: &dyn Ports<T>) -> MarkerMotion<T> {
        let mut motion = MarkerMotion::fixed(self.position, self.orientation);
        self.move_with(ports, &mut motion);
        motion
    }

    /// Sets place and motion of the attached triad, where they stay.
    #[inline]
    pub(super) fn put_motion(&self, ports: &dyn Ports<T>, to: &mut MarkerMotion<T>) {
        if !self.move_with(ports, to) {
            *to = MarkerMotion::fixed(self.position, self.orientation);
        }
    }

    /// Sets place and motion of a triad on a body; on the ground nothing.
    #[inline]
    fn move_with(&self, ports: &dyn Ports<T>, to: &mut MarkerMotion<T>) -> bool {
        let Some(port) = self.body.and_then(|body| ports.port(body)) else { return false };
        port.marker_motion(self.marker, to);
        to.turn(&self.orientation);
        true
    }

    /// The attached triad over a step of the energy-momentum method; `None` on the ground and outside of those.
    pub fn over_step(&self, ports: &dyn Ports<T>) -> Option<MarkerStep<T>> {
        let port = self.body.and_then(|body| ports.port(body))?;
        port.marker_step(self.marker).map(|step| step.turned(&self.orientation))
    }
}

/// A joint between two attachments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Connection<T: RealField + Copy = f64> {
    /// What it holds.
    pub kind: JointKind<T>,
    /// Its first end; axes are those of this triad.
    pub first: Attachment<T>,
    /// Its second end.
    pub second: Attachment<T>,
}
