//! Mechanisms in another number type: their constants are f64, dual numbers give derivatives.

use nalgebra::{Quaternion, RealField, UnitQuaternion, Vector3, convert};

use super::{Attachment, Connection, JointFriction};
use crate::forces::Friction;

impl Attachment<f64> {
    /// The same attachment in another number type.
    pub fn cast<T: RealField + Copy>(&self) -> Attachment<T> {
        Attachment {
            body: self.body,
            marker: self.marker,
            position: cast_vector(&self.position),
            orientation: cast_rotation(&self.orientation),
        }
    }
}

impl JointFriction<f64> {
    /// The same friction in another number type.
    pub fn cast<T: RealField + Copy>(&self) -> JointFriction<T> {
        JointFriction {
            joint: self.joint,
            kind: self.kind.cast(),
            coefficient: convert(self.coefficient),
            arm: convert(self.arm),
        }
    }
}

impl Friction<f64> {
    /// The same friction in another number type.
    pub fn cast<T: RealField + Copy>(&self) -> Friction<T> {
        Friction {
            effort: self.effort,
            limit: convert(self.limit),
            speed: convert(self.speed),
            viscous: convert(self.viscous),
        }
    }
}

impl Connection<f64> {
    /// The same connection in another number type.
    pub fn cast<T: RealField + Copy>(&self) -> Connection<T> {
        Connection { kind: self.kind.cast(), first: self.first.cast(), second: self.second.cast() }
    }
}

fn cast_vector<T: RealField + Copy>(vector: &Vector3<f64>) -> Vector3<T> {
    vector.map(convert)
}

fn cast_rotation<T: RealField + Copy>(rotation: &UnitQuaternion<f64>) -> UnitQuaternion<T> {
    UnitQuaternion::new_unchecked(Quaternion::from(rotation.coords.map(convert)))
}
