//! Force elements between two attachments.

use ffrf_runtime::forces::{Bushing, Spring, TorsionSpring};
use ffrf_runtime::mechanism::{Attachment, Ports};
use ffrf_runtime::{MarkerMotion, Wrench};
use nalgebra::{RealField, Vector3, convert};

/// What acts between two attachments.
#[derive(Debug, Clone, PartialEq)]
pub enum ElementKind<T: RealField + Copy = f64> {
    /// See [`Spring`].
    Spring(Spring<T>),
    /// See [`TorsionSpring`].
    TorsionSpring(TorsionSpring<T>),
    /// See [`Bushing`].
    Bushing(Bushing<T>),
    /// A constant force (N) at the second attachment.
    Force {
        /// Shape: 3. Units: N.
        value: Vector3<T>,
        /// Whether it turns with the body.
        follows: bool,
    },
    /// A constant moment (N m) at the second attachment.
    Moment {
        /// Shape: 3. Units: N m.
        value: Vector3<T>,
        /// Whether it turns with the body.
        follows: bool,
    },
}

/// A force element and what it is attached to.
#[derive(Debug, Clone, PartialEq)]
pub struct Element<T: RealField + Copy = f64> {
    /// What acts.
    pub kind: ElementKind<T>,
    /// Where it begins.
    pub first: Attachment<T>,
    /// Where it acts.
    pub second: Attachment<T>,
}

impl<T: RealField + Copy> Element<T> {
    /// Adds its wrenches to the forces on the bodies.
    pub fn apply(&self, ports: &mut dyn Ports<T>) {
        let (first, second) = (self.first.motion(ports), self.second.motion(ports));
        let wrenches = self.wrenches(&first, &second);
        for (attachment, wrench) in [&self.first, &self.second].into_iter().zip(&wrenches) {
            if let Some(port) = attachment.body.and_then(|body| ports.port_mut(body)) {
                port.push(attachment.marker, wrench);
            }
        }
    }

    /// Stored energy. Units: J.
    pub fn energy(&self, ports: &dyn Ports<T>) -> T {
        let (first, second) = (self.first.motion(ports), self.second.motion(ports));
        match &self.kind {
            ElementKind::Spring(spring) => spring.energy(&first, &second),
            ElementKind::TorsionSpring(spring) => spring.energy(&first, &second),
            ElementKind::Bushing(bushing) => bushing.energy(&first, &second),
            ElementKind::Force { .. } | ElementKind::Moment { .. } => T::zero(),
        }
    }

    /// Whether this is a force or moment with a direction, which can be an input.
    pub fn grows(&self) -> bool {
        match &self.kind {
            ElementKind::Force { value, .. } | ElementKind::Moment { value, .. } => {
                value.norm_squared() > T::zero()
            }
            _ => false,
        }
    }

    /// Makes a force or moment larger by `amount` (N or N m) along its own direction; other elements stay.
    pub fn grow(&mut self, amount: T) {
        if let ElementKind::Force { value, .. } | ElementKind::Moment { value, .. } = &mut self.kind
            && value.norm_squared() > T::zero()
        {
            *value += *value / value.norm() * amount;
        }
    }

    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2] {
        let turned = |value: &Vector3<T>, follows: bool| {
            if follows { second.orientation.transform_vector(value) } else { *value }
        };
        match &self.kind {
            ElementKind::Spring(spring) => spring.wrenches(first, second),
            ElementKind::TorsionSpring(spring) => spring.wrenches(first, second),
            ElementKind::Bushing(bushing) => bushing.wrenches(first, second),
            ElementKind::Force { value, follows } => {
                [Wrench::zero(), Wrench { force: turned(value, *follows), moment: Vector3::zeros() }]
            }
            ElementKind::Moment { value, follows } => {
                [Wrench::zero(), Wrench { force: Vector3::zeros(), moment: turned(value, *follows) }]
            }
        }
    }
}

impl Element {
    /// The same element in another number type.
    pub fn cast<T: RealField + Copy>(&self) -> Element<T> {
        let number = |x: f64| convert::<f64, T>(x);
        let kind = match &self.kind {
            ElementKind::Spring(spring) => ElementKind::Spring(Spring {
                stiffness: number(spring.stiffness),
                damping: number(spring.damping),
                rest_length: number(spring.rest_length),
            }),
            ElementKind::TorsionSpring(spring) => ElementKind::TorsionSpring(TorsionSpring {
                stiffness: number(spring.stiffness),
                damping: number(spring.damping),
                rest_angle: number(spring.rest_angle),
            }),
            ElementKind::Bushing(bushing) => ElementKind::Bushing(Bushing {
                stiffness: bushing.stiffness.map(number),
                damping: bushing.damping.map(number),
            }),
            ElementKind::Force { value, follows } => {
                ElementKind::Force { value: value.map(number), follows: *follows }
            }
            ElementKind::Moment { value, follows } => {
                ElementKind::Moment { value: value.map(number), follows: *follows }
            }
        };
        Element { kind, first: self.first.cast(), second: self.second.cast() }
    }
}
