//! Friction and reactions, which depend on each other, solved for together.

use nalgebra::RealField;

use super::{Assembly, Constraints, JointFriction, Target, reaction};
use crate::body::{MarkerMotion, Wrench};
use crate::integrators::StepError;

/// Most passes of the iteration. The share of the error that each pass leaves is about the coefficient of friction times
/// what a unit of friction adds to the reaction: below one half wherever a mechanism does not lock itself.
pub const FRICTION_PASSES: usize = 40;

/// The change of an effort, relative to it, that ends the iteration, over the root of round-off. Reactions that stiff modes
/// and redundant rows make noisy are not asked for more digits than they have.
const SETTLED: f64 = 1e-2;

/// Reactions below this share of the largest multiplier are noise.
const NOISE: f64 = 1e-9;

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
        let most = T::default_epsilon().sqrt();
        let tolerance: T = most * nalgebra::convert(SETTLED);
        let mut left = T::zero();
        for _ in 0..FRICTION_PASSES {
            left = T::zero();
            let noise = self.largest_multiplier() * per_multiplier * nalgebra::convert(NOISE);
            let mut index = 0;
            while let Some(friction) = assembly.friction(index) {
                left = left.max(self.renew(index, &friction, per_multiplier, noise));
                index += 1;
            }
            self.accelerate(target);
            if left <= tolerance {
                return Ok(());
            }
        }
        if left <= most { Ok(()) } else { Err(StepError::not_converged(FRICTION_PASSES, left / most)) }
    }

    fn largest_multiplier(&self) -> T {
        let multipliers = self
            .plan
            .joints
            .iter()
            .take(self.connections.len())
            .filter_map(|place| Some(self.storage.solution.get(place.node)?.iter().take(place.rows)))
            .flatten();
        multipliers.fold(T::zero(), |largest, multiplier| largest.max(multiplier.abs()))
    }

    /// The friction that [`rub`](Self::rub) found in another evaluation of the same state.
    pub(super) fn rub_as<A: Assembly<T>>(&mut self, assembly: &A, efforts: &[T]) {
        let mut index = 0;
        while let (Some(friction), Some(effort)) = (assembly.friction(index), efforts.get(index)) {
            if let Some(ends) = self.ends_of(friction.joint) {
                self.push_net(&friction, &ends, *effort);
            }
            index += 1;
        }
    }

    /// Renews one friction by the reaction as it is now; gives its change, relative to it.
    fn renew(&mut self, index: usize, friction: &JointFriction<T>, per_multiplier: T, noise: T) -> T {
        let (Some([first, second]), Some(before)) =
            (self.ends_of(friction.joint), self.storage.efforts.get(index).copied())
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
        let size = effort.abs().max(before.abs()).max(friction.coefficient * friction.arm * noise);
        if size > T::zero() { change.abs() / size } else { T::zero() }
    }

    fn ends_of(&self, joint: usize) -> Option<[MarkerMotion<T>; 2]> {
        self.storage.joints.get(joint)?.map(|joint| joint.ends)
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
