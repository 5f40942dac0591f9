//! Friction in a joint that follows the joint's reaction.

use nalgebra::RealField;

use super::{Assembly, Constraints, Target, reaction};
use crate::body::{MarkerMotion, Wrench};
use crate::forces::Friction;
use crate::integrators::StepError;

/// Friction in a joint whose limit grows with the reaction of that joint: `kind.limit + coefficient · arm · N`.
///
/// N is the norm of the force of the joint itself, its drives left out, at the same instant: friction changes reactions, and
/// they change friction, so both are solved for together, by fixed-point iteration with the factors that are there. So
/// friction depends on state and time alone, there is nothing to remember between steps, and explicit integrators keep
/// their order; in linearly implicit steps N is that of the stage's own equations, where stiff modes give way to first order
/// in the step. Moments that a joint bears (a long guide that is tilted) do not add to N.
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

/// Most passes of the iteration. The share of the error that each pass leaves is about the coefficient of friction times
/// what a unit of friction adds to the reaction: below one half wherever a mechanism does not lock itself.
pub const FRICTION_PASSES: usize = 40;

/// Ends the iteration: the change of an effort, relative to it, in units of round-off.
const SETTLED: f64 = 64.0;

impl<T: RealField + Copy> Constraints<'_, '_, T> {
    /// Adds the friction that follows reactions to accelerations that were found without it.
    ///
    /// `per_multiplier`: reaction over multiplier; one unless unknowns are changes of velocities. Units: those of 1.
    ///
    /// Errors: [`StepError::NotConverged`] where friction and reaction hold each other (a mechanism that locks itself).
    pub(super) fn rub<A: Assembly<T>>(
        &mut self,
        assembly: &A,
        target: Target<T>,
        per_multiplier: T,
    ) -> Result<(), StepError> {
        if assembly.friction(0).is_none() {
            return Ok(());
        }
        self.storage.efforts.fill(T::zero());
        let tolerance: T = T::default_epsilon() * nalgebra::convert(SETTLED);
        let mut left = T::zero();
        for _ in 0..FRICTION_PASSES {
            left = T::zero();
            let mut index = 0;
            while let Some(friction) = assembly.friction(index) {
                left = left.max(self.renew(index, &friction, per_multiplier));
                index += 1;
            }
            self.accelerate(target);
            if left <= tolerance {
                return Ok(());
            }
        }
        Err(StepError::not_converged(FRICTION_PASSES, left / tolerance))
    }

    /// The friction that [`rub`](Self::rub) found in another evaluation of the same state.
    pub(super) fn rub_as<A: Assembly<T>>(&mut self, assembly: &A, efforts: &[T]) {
        let mut index = 0;
        while let (Some(friction), Some(effort)) = (assembly.friction(index), efforts.get(index)) {
            if let Some([first, second]) = self.storage.ends.get(friction.joint).copied() {
                self.push_net(&friction, &[first, second], *effort);
            }
            index += 1;
        }
    }

    /// Renews one friction by the reaction as it is now; gives its change, relative to it.
    fn renew(&mut self, index: usize, friction: &JointFriction<T>, per_multiplier: T) -> T {
        let (Some([first, second]), Some(before)) =
            (self.storage.ends.get(friction.joint).copied(), self.storage.efforts.get(index).copied())
        else {
            return T::zero();
        };
        let normal = reaction(&self.plan, self.storage, friction.joint).force.norm() * per_multiplier;
        let effort = friction.exerted(normal, friction.kind.effort.rate(&first, &second));
        let change = effort - before;
        self.push_net(friction, &[first, second], change);
        if let Some(place) = self.storage.efforts.get_mut(index) {
            *place = effort;
        }
        // not a number is no convergence
        if !change.is_finite() {
            return T::max_value().unwrap_or(T::one());
        }
        let size = effort.abs().max(before.abs());
        if size > T::zero() { change.abs() / size } else { T::zero() }
    }

    fn push_net(&mut self, friction: &JointFriction<T>, ends: &[MarkerMotion<T>; 2], effort: T) {
        let Some(connection) = self.connections.get(friction.joint) else { return };
        let wrenches: [Wrench<T>; 2] = friction.kind.effort.wrenches(&ends[0], &ends[1], effort);
        for (attachment, wrench) in [&connection.first, &connection.second].into_iter().zip(&wrenches) {
            if let Some(port) = attachment.body.and_then(|body| self.ports.port_mut(body)) {
                port.push_net(attachment.marker, wrench);
            }
        }
    }
}
