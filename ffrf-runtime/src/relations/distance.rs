//! Two points keep a distance.

use nalgebra::{RealField, Vector3};

use super::Row;
use crate::body::{MarkerMotion, Wrench};

/// (|d|² - L²) / (2 L) = 0 with d = r₂ - r₁: smooth, and |d| - L to first order. `length` L: m, not zero.
pub fn distance<T: RealField + Copy>(first: &MarkerMotion<T>, second: &MarkerMotion<T>, length: T) -> Row<T> {
    let half: T = nalgebra::convert(0.5);
    let between = second.position - first.position;
    let velocity = second.velocity - first.velocity;
    let direction = between / length;
    Row {
        residual: (between.norm_squared() / length - length) * half,
        first: Wrench { force: -direction, moment: Vector3::zeros() },
        second: Wrench { force: direction, moment: Vector3::zeros() },
        rate: T::zero(),
        bias: velocity.norm_squared() / length,
    }
}
