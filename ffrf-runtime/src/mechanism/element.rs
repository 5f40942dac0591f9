//! Force elements with what they act between.

use nalgebra::RealField;

use super::{Attachment, Ports, SoftLink};
use crate::body::MarkerStep;
use crate::forces::ForceElement;

/// A force element between two attachments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Element<K, T: RealField + Copy = f64> {
    /// What acts.
    pub kind: K,
    /// Where it begins.
    pub first: Attachment<T>,
    /// Where it acts.
    pub second: Attachment<T>,
}

impl<K: ForceElement<T>, T: RealField + Copy> Element<K, T> {
    /// As implicit steps take it into their matrix.
    pub fn soft(&self) -> SoftLink<'_, T> {
        SoftLink { element: &self.kind, ends: [&self.first, &self.second] }
    }

    /// Adds its wrenches to the forces on the bodies.
    pub fn apply(&self, ports: &mut dyn Ports<T>) {
        let wrenches = match self.over_step(ports) {
            Some([first, second]) => self.kind.wrenches_over(&first, &second),
            None => self.kind.wrenches(&self.first.motion(ports), &self.second.motion(ports)),
        };
        for (attachment, wrench) in [&self.first, &self.second].into_iter().zip(&wrenches) {
            if let Some(port) = attachment.body.and_then(|body| ports.port_mut(body)) {
                port.push(attachment.marker, wrench);
            }
        }
    }

    /// Both ends over a step of the energy-momentum method.
    fn over_step(&self, ports: &dyn Ports<T>) -> Option<[MarkerStep<T>; 2]> {
        let still = |end: &Attachment<T>, step: T| MarkerStep::still(end.motion(ports), step);
        match (self.first.over_step(ports), self.second.over_step(ports)) {
            (None, None) => None,
            (Some(first), Some(second)) => Some([first, second]),
            (Some(first), None) => Some([first, still(&self.second, first.step)]),
            (None, Some(second)) => Some([still(&self.first, second.step), second]),
        }
    }

    /// Stored energy. Units: J.
    pub fn energy(&self, ports: &dyn Ports<T>) -> T {
        self.kind.energy(&self.first.motion(ports), &self.second.motion(ports))
    }
}
