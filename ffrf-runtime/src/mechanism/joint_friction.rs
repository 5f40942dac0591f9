//! Friction in a joint that follows the joint's reaction.

use nalgebra::RealField;

use crate::forces::Friction;

/// Friction in a joint whose limit grows with the reaction of that joint: `kind.limit + coefficient · arm · N`.
///
/// N is the norm of the force of the joint itself, its drives left out, at the same instant: friction changes reactions, and
/// they change friction, so both are solved for together, by fixed-point iteration with the factors that are there. So
/// friction depends on state and time alone, there is nothing to remember between steps, and explicit integrators keep
/// their order; in linearly implicit steps N is extrapolated from that of the stage's own equations, where stiff modes give
/// way, and of a stage half as long, so that they keep theirs. Moments that a joint bears (a long guide that is tilted) do not add to N.
///
/// Source of the law: Coulomb's with the smooth passage through rest of [`Friction`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointFriction<T = f64> {
    /// The joint among the connections of its mechanism.
    pub joint: usize,
    /// Where it acts, how fast motion must be, and what does not follow the reaction.
    pub kind: Friction<T>,
    /// Coefficient of friction. Units: 1.
    pub coefficient: T,
    /// What a force of friction becomes the effort by: the radius of the bearing (m) about an axis, 1 along it.
    pub arm: T,
}

impl<T: RealField + Copy> JointFriction<T> {
    /// The effort on the second end. `normal`: force of the joint (N), `rate`: m/s or rad/s. Units: N or N m.
    pub fn exerted(&self, normal: T, rate: T) -> T {
        let limit = self.kind.limit + self.coefficient * self.arm * normal;
        Friction { limit, ..self.kind }.exerted(rate)
    }
}
