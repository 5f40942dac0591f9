//! One scalar constraint between two markers, at position, velocity and acceleration level.

use nalgebra::{RealField, Vector3};

use crate::body::{MarkerMotion, Wrench};

/// A scalar relation g = 0 between two markers with the derivatives that follow from it.
///
/// ```text
/// ġ = first · [v; ω]_first + second · [v; ω]_second + rate
/// g̈ = first · [v̇; ω̇]_first + second · [v̇; ω̇]_second + bias
/// ```
///
/// Frame of all vectors: inertial. The residual is the single truth; tests derive the rest from it by dual numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row<T = f64> {
    /// g. Units: m or rad.
    pub residual: T,
    /// Gradient to the velocities of the first marker.
    pub first: Wrench<T>,
    /// Gradient to the velocities of the second marker.
    pub second: Wrench<T>,
    /// Partial derivative of g to time. Units: m/s or rad/s.
    pub rate: T,
    /// What g̈ has besides accelerations. Units: m/s² or rad/s².
    pub bias: T,
}

impl<T: RealField + Copy> Row<T> {
    /// A row without any effect.
    pub fn zero() -> Self {
        let zero = T::zero();
        Self { residual: zero, first: Wrench::zero(), second: Wrench::zero(), rate: zero, bias: zero }
    }

    /// ġ in the motion of both markers.
    pub fn velocity(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        self.first.power(&first.velocity, &first.angular_velocity)
            + self.second.power(&second.velocity, &second.angular_velocity)
            + self.rate
    }

    /// What g̈ has besides the accelerations of the bodies: the bias and that of both markers.
    pub fn whole_bias(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        self.first.power(&first.acceleration_bias, &first.angular_acceleration_bias)
            + self.second.power(&second.acceleration_bias, &second.angular_acceleration_bias)
            + self.bias
    }
}

/// The most rows that one joint has.
pub const MOST_ROWS: usize = 6;

/// The rows of one joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rows<T = f64> {
    rows: [Row<T>; MOST_ROWS],
    count: usize,
}

impl<T: RealField + Copy> Rows<T> {
    /// No rows.
    pub fn none() -> Self {
        Self { rows: [Row::zero(); MOST_ROWS], count: 0 }
    }

    /// Adds a row; beyond [`MOST_ROWS`] it is left out, which no joint reaches.
    pub fn push(&mut self, row: Row<T>) {
        if let Some(place) = self.rows.get_mut(self.count) {
            *place = row;
            self.count += 1;
        }
    }

    /// The rows.
    pub fn as_slice(&self) -> &[Row<T>] {
        self.rows.get(..self.count).unwrap_or(&[])
    }

    /// The rows, to write to.
    pub(crate) fn as_mut_slice(&mut self) -> &mut [Row<T>] {
        self.rows.get_mut(..self.count).unwrap_or(&mut [])
    }
}

/// The axes of a triad. Frame: inertial.
pub(crate) fn axes<T: RealField + Copy>(motion: &MarkerMotion<T>) -> [Vector3<T>; 3] {
    let axes = motion.axes();
    [axes.column(0).into(), axes.column(1).into(), axes.column(2).into()]
}
