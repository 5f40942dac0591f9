//! One motion that a joint leaves.

use nalgebra::{RealField, Vector3};

use crate::six::{Square, add_scaled, dot, scaled, subtract_scaled};

/// One motion that a joint leaves, and what a body resists it with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Freedom<T = f64> {
    /// Velocity or angular velocity of a unit of it. Frame: inertial.
    direction: Vector3<T>,
    /// A s, with the motions before it taken out. Shape: 6.
    effect: [T; 6],
    /// 1 / (sᵀ A s)
    inverse: T,
    /// Its acceleration if the end of the joint did not move.
    alone: T,
}

impl<T: RealField + Copy> Freedom<T> {
    /// Puts a motion where it stays, and takes it out of what resists it. Whether it meets something. `FIRST`: 0 for translations,
    /// 3 for rotations.
    #[inline]
    pub(crate) fn put<const FIRST: usize>(
        place: Option<&mut Option<Self>>,
        direction: &Vector3<T>,
        inertia: &mut Square<T>,
    ) -> bool {
        let Some(place) = place else { return false };
        let [x, y, z]: [T; 3] = (*direction).into();
        let mut effect = scaled(x, &inertia[FIRST]);
        add_scaled(&mut effect, y, &inertia[FIRST + 1]);
        add_scaled(&mut effect, z, &inertia[FIRST + 2]);
        let inverse = T::one() / (effect[FIRST] * x + effect[FIRST + 1] * y + effect[FIRST + 2] * z);
        let shares = scaled(inverse, &effect);
        for (row, share) in inertia.iter_mut().zip(shares) {
            subtract_scaled(row, share, &effect);
        }
        // number by number: what is made elsewhere and copied in wider pieces waits for its stores
        let none = T::zero();
        let motion = place.get_or_insert_with(|| Self {
            direction: Vector3::zeros(),
            effect: [none; 6],
            inverse: none,
            alone: none,
        });
        (motion.direction, motion.effect, motion.inverse) = (*direction, effect, inverse);
        inverse.is_finite() && inverse != none
    }

    /// Lets the motion go under a force, and takes out of the force what that costs.
    #[inline]
    pub(crate) fn yield_to<const FIRST: usize>(&mut self, force: &mut [T; 6]) {
        let [x, y, z]: [T; 3] = self.direction.into();
        self.alone = self.inverse * (force[FIRST] * x + force[FIRST + 1] * y + force[FIRST + 2] * z);
        subtract_scaled(force, self.alone, &self.effect);
    }

    /// Adds the motion to that of the end of the joint and of the motions after it.
    #[inline]
    pub(crate) fn follow<const FIRST: usize>(&self, twist: &mut [T; 6]) {
        let amount = self.alone - self.inverse * dot(&self.effect, twist);
        let [x, y, z]: [T; 3] = self.direction.into();
        twist[FIRST] += amount * x;
        twist[FIRST + 1] += amount * y;
        twist[FIRST + 2] += amount * z;
    }
}
