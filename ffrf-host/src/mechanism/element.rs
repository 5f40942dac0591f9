//! Force elements between two attachments.

use ffrf_runtime::forces::{Actuator, Bushing, Friction, Spring, TorsionSpring};
use ffrf_runtime::mechanism::{Attachment, Ports};
use ffrf_runtime::{MarkerMotion, Wrench};
use nalgebra::Vector3;

use super::Drive;

/// What acts between two attachments.
#[derive(Debug, Clone, PartialEq)]
pub enum ElementKind {
    /// See [`Spring`].
    Spring(Spring),
    /// See [`TorsionSpring`].
    TorsionSpring(TorsionSpring),
    /// See [`Bushing`].
    Bushing(Bushing),
    /// See [`Friction`].
    Friction(Friction),
    /// See [`Actuator`].
    Actuator {
        /// What it exerts at an input.
        actuator: Actuator,
        /// Its input as a function of time; its derivatives are of no effect.
        input: Drive,
    },
    /// A constant force (N) at the second attachment.
    Force {
        /// Shape: 3. Units: N.
        value: Vector3<f64>,
        /// Whether it turns with the body.
        follows: bool,
    },
    /// A constant moment (N m) at the second attachment.
    Moment {
        /// Shape: 3. Units: N m.
        value: Vector3<f64>,
        /// Whether it turns with the body.
        follows: bool,
    },
}

/// A force element and what it is attached to.
#[derive(Debug, Clone, PartialEq)]
pub struct Element {
    /// What acts.
    pub kind: ElementKind,
    /// Where it begins.
    pub first: Attachment<f64>,
    /// Where it acts.
    pub second: Attachment<f64>,
}

impl Element {
    /// Adds its wrenches at `time` (s) to the forces on the bodies.
    pub fn apply(&self, time: f64, ports: &mut dyn Ports<f64>) {
        let (first, second) = (self.first.motion(ports), self.second.motion(ports));
        let wrenches = self.wrenches(time, &first, &second);
        for (attachment, wrench) in [&self.first, &self.second].into_iter().zip(&wrenches) {
            if let Some(port) = attachment.body.and_then(|body| ports.port_mut(body)) {
                port.push(attachment.marker, wrench);
            }
        }
    }

    /// Stored energy. Units: J.
    pub fn energy(&self, ports: &dyn Ports<f64>) -> f64 {
        let (first, second) = (self.first.motion(ports), self.second.motion(ports));
        match &self.kind {
            ElementKind::Spring(spring) => spring.energy(&first, &second),
            ElementKind::TorsionSpring(spring) => spring.energy(&first, &second),
            ElementKind::Bushing(bushing) => bushing.energy(&first, &second),
            ElementKind::Friction(_)
            | ElementKind::Actuator { .. }
            | ElementKind::Force { .. }
            | ElementKind::Moment { .. } => 0.0,
        }
    }

    fn wrenches(&self, time: f64, first: &MarkerMotion, second: &MarkerMotion) -> [Wrench; 2] {
        let turned = |value: &Vector3<f64>, follows: bool| {
            if follows { second.orientation.transform_vector(value) } else { *value }
        };
        match &self.kind {
            ElementKind::Spring(spring) => spring.wrenches(first, second),
            ElementKind::TorsionSpring(spring) => spring.wrenches(first, second),
            ElementKind::Bushing(bushing) => bushing.wrenches(first, second),
            ElementKind::Friction(friction) => friction.wrenches(first, second),
            ElementKind::Actuator { actuator, input } => {
                let [input, ..] = input.at(time);
                actuator.wrenches(first, second, input)
            }
            ElementKind::Force { value, follows } => {
                [Wrench::zero(), Wrench { force: turned(value, *follows), moment: Vector3::zeros() }]
            }
            ElementKind::Moment { value, follows } => {
                [Wrench::zero(), Wrench { force: Vector3::zeros(), moment: turned(value, *follows) }]
            }
        }
    }
}
