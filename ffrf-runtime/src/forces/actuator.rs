//! An actuator: a force or moment that a control input commands.

use nalgebra::RealField;

use super::Effort;
use crate::body::{MarkerMotion, Wrench};

/// An actuator between two triads, without inertia of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Actuator<T = f64> {
    /// Where it acts.
    pub effort: Effort,
    /// Force or moment per unit of the input. Units: N or N m per unit.
    pub gain: T,
    /// The largest force or moment it can exert, either way. Units: N or N m.
    pub limit: T,
}

impl<T: RealField + Copy> Actuator<T> {
    /// Wrenches on both ends (inertial) at this input.
    pub fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>, input: T) -> [Wrench<T>; 2] {
        self.effort.wrenches(first, second, self.exerted(input))
    }

    /// The force or moment at this input: `gain` times it, at most the limit. Units: N or N m.
    pub fn exerted(&self, input: T) -> T {
        (self.gain * input).max(-self.limit).min(self.limit)
    }
}
