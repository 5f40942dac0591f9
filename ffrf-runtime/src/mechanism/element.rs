//! Force elements with what they act between.

use nalgebra::RealField;

use super::{Attachment, Ports};
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
    /// Adds its wrenches to the forces on the bodies.
    pub fn apply(&self, ports: &mut dyn Ports<T>) {
        let (first, second) = (self.first.motion(ports), self.second.motion(ports));
        let wrenches = self.kind.wrenches(&first, &second);
        for (attachment, wrench) in [&self.first, &self.second].into_iter().zip(&wrenches) {
            if let Some(port) = attachment.body.and_then(|body| ports.port_mut(body)) {
                port.push(attachment.marker, wrench);
            }
        }
    }

    /// Stored energy. Units: J.
    pub fn energy(&self, ports: &dyn Ports<T>) -> T {
        self.kind.energy(&self.first.motion(ports), &self.second.motion(ports))
    }
}
