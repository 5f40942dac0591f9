//! Dry friction in a joint, smooth at rest.

use nalgebra::RealField;

use super::{Effort, ForceElement, SoftRow};
use crate::body::{MarkerMotion, Wrench};

/// Coulomb friction with a smooth passage through rest, and viscous friction: -(limit / √(v² + speed²) + viscous) v.
///
/// The friction of a bearing whose load is known; it does not follow the joint's reaction. A body at rest creeps under
/// a force f below the limit with speed f / √(limit² - f²) times `speed`; near rest it is a damper of limit / speed, which
/// explicit steps have to resolve and implicit ones take into their matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction<T = f64> {
    /// Where it acts.
    pub effort: Effort,
    /// Friction of fast motion. Units: N or N m.
    pub limit: T,
    /// Speed of the passage, where 71 % of the limit are reached; positive. Units: m/s or rad/s.
    pub speed: T,
    /// Viscous part. Units: N s/m or N m s/rad.
    pub viscous: T,
}

impl<T: RealField + Copy> ForceElement<T> for Friction<T> {
    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2] {
        let rate = self.effort.rate(first, second);
        self.effort.wrenches(first, second, self.exerted(rate))
    }

    /// One: a damper with the slope that friction has at this rate.
    fn soften(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>, push: &mut dyn FnMut(SoftRow<T>)) {
        let rate = self.effort.rate(first, second);
        let squares = rate * rate + self.speed * self.speed;
        let slope = self.limit * self.speed * self.speed / (squares * squares.sqrt());
        let [on_first, on_second] = self.effort.wrenches(first, second, T::one());
        push(SoftRow {
            first: on_first,
            second: on_second,
            stiffness: T::zero(),
            damping: slope + self.viscous,
        });
    }
}

impl<T: RealField + Copy> Friction<T> {
    /// The force or moment on the second end at this rate. Units: N or N m.
    pub fn exerted(&self, rate: T) -> T {
        -rate * (self.limit / (rate * rate + self.speed * self.speed).sqrt() + self.viscous)
    }
}
