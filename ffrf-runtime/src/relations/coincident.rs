//! Two points coincide: r₂ - r₁ = 0, three rows in inertial components.

use nalgebra::{RealField, Vector3};

use super::{Row, Rows};
use crate::body::{MarkerMotion, Wrench};

/// Adds the three rows of r₂ - r₁ = 0.
pub fn coincident<T: RealField + Copy>(
    rows: &mut Rows<T>,
    first: &MarkerMotion<T>,
    second: &MarkerMotion<T>,
) {
    let distance = second.position - first.position;
    for (axis, residual) in [Vector3::x(), Vector3::y(), Vector3::z()].into_iter().zip(distance.iter()) {
        rows.push(Row {
            residual: *residual,
            first: Wrench { force: -axis, moment: Vector3::zeros() },
            second: Wrench { force: axis, moment: Vector3::zeros() },
            rate: T::zero(),
            bias: T::zero(),
        });
    }
}
