//! A state after one correction onto the joints.

use nalgebra::RealField;

/// The share of a step's drift that its projection may leave: what a step leaves open is of the size of its error, and more
/// digits of it say nothing about the motion.
const ENOUGH: f64 = 1e-6;

/// Round-off of a residual: in units of ε, and of ε times the largest number that it is a difference of.
const ROUND_OFF: [f64; 2] = [16.0, 2.0];

/// Residuals that no correction makes smaller: the round-off of what they are differences of, the `largest` of which is this.
pub(super) fn round_off<T: RealField + Copy>(largest: T) -> T {
    let [units, share]: [T; 2] = ROUND_OFF.map(|units| T::default_epsilon() * nalgebra::convert(units));
    units.max(share * largest)
}

/// What may be left of a residual that was `before`.
pub(super) fn enough<T: RealField + Copy>(before: T, round_off: T) -> T {
    round_off.max(before * nalgebra::convert(ENOUGH))
}

/// A state after one correction of places and one of velocities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projected<S, T = f64> {
    /// The state.
    pub state: S,
    /// The largest residuals of places and of velocities before. Units: m or rad; m/s or rad/s.
    pub before: [T; 2],
    /// The same behind the corrections.
    pub after: [T; 2],
    /// The largest place and velocity of a body. Units: m; m/s or rad/s.
    pub sizes: [T; 2],
}

impl<S, T: RealField + Copy> Projected<S, T> {
    /// Whether nothing is left that another correction would take away.
    pub(super) fn is_closed(&self) -> bool {
        // not a number is not met
        let small = |k: usize| self.after[k] <= enough(self.before[k], round_off(self.sizes[k]));
        small(0) && small(1)
    }

    /// Whether it is closed, within the tolerance of places. Units: m or rad.
    pub(super) fn meets(&self, tolerance: T) -> bool {
        self.is_closed() && self.after[0] <= tolerance
    }
}
