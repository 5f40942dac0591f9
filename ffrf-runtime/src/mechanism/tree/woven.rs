//! The modes of a body in a tree, with all that hangs on it.

use nalgebra::{RealField, Vector3};

use crate::body::ModalVector;
use crate::six::{Square, add, add_moment, add_scaled, dot, subtract_scaled};

/// The modes of a body in a tree, which what hangs on it couples with each other. Frame: inertial, about the end of the body's
/// joint.
///
/// With a the motion of the body's frame and Φ_e what the modes add to it at an end e of a joint, the body has Z, C and Θ of a
/// and the modes, to which each thing that hangs at an end c adds Xᵀ A X, Xᵀ A Φ_c and Φ_cᵀ A Φ_c. The motion of the end of the
/// body's own joint is t = a + Φ q̈: in t and the modes these are Z, C - Z Φ and Θ - Φᵀ C - (C - Z Φ)ᵀ Φ, of which the modes are
/// eliminated one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Woven<V: ModalVector<T>, T: RealField + Copy> {
    /// Cᵀ, then that of t with the modes before each taken out. Shape: M x 6.
    pub(crate) coupling: V::Sixes,
    /// Θ, then its pivots' inverses on the diagonal and Lᵀ D above. Shape: M x M, of which what is not below the diagonal counts.
    modal: V::Matrix,
    /// The force on the modes; then their accelerations. Shape: M.
    pub(crate) force: V,
}

impl<V: ModalVector<T>, T: RealField + Copy> Woven<V, T> {
    /// Of a body alone. Shape: M x 6, M x M.
    pub(crate) fn new(coupling: V::Sixes, modal: V::Matrix, zeros: V) -> Self {
        Self { coupling, modal, force: zeros }
    }

    /// Adds what hangs at an end. `twists`: Φᵀ there; `arm`: from the end of the body's joint. Shape: M x 6.
    pub(crate) fn bear(&mut self, inertia: &Square<T>, twists: &[[T; 6]], arm: &Vector3<T>) {
        let count = twists.len();
        let mut rows = V::entries_mut(&mut self.modal).chunks_exact_mut(count.max(1));
        for (mode, (twist, place)) in twists.iter().zip(self.coupling.as_mut()).enumerate() {
            let mut met = [T::zero(); 6];
            for (row, amount) in inertia.iter().zip(twist) {
                add_scaled(&mut met, *amount, row);
            }
            if let Some(row) = rows.next() {
                for (entry, other) in row.iter_mut().zip(twists).skip(mode) {
                    *entry += dot(&met, other);
                }
            }
            add_moment(&mut met, arm);
            add(place, &met);
        }
    }

    /// Goes from the motion of the frame to that of the end of the body's joint. `twists`: Φᵀ there. Shape: M x 6.
    pub(crate) fn lean(&mut self, inertia: &Square<T>, twists: &[[T; 6]]) {
        let count = twists.len();
        let mut rows = V::entries_mut(&mut self.modal).chunks_exact_mut(count.max(1));
        for mode in 0..count {
            let (Some(twist), Some(row)) = (twists.get(mode), rows.next()) else { return };
            let coupling = self.coupling.as_mut();
            let Some(own) = coupling.get_mut(mode) else { return };
            let before = *own;
            for (row, amount) in inertia.iter().zip(twist) {
                subtract_scaled(own, *amount, row);
            }
            // modes before this one lean already
            let own = *own;
            for (later, entry) in row.iter_mut().enumerate().skip(mode) {
                let (Some(other), Some(coupled)) = (twists.get(later), coupling.get(later)) else { return };
                let coupled = if later == mode { &before } else { coupled };
                *entry -= dot(&own, other) + dot(coupled, twist);
            }
        }
    }

    /// Eliminates the modes; takes them out of what the frame resists with. `None` where a pivot is not positive.
    pub(crate) fn eliminate(&mut self, inertia: &mut Square<T>) -> Option<()> {
        let count = self.force.as_slice().len();
        let entries = V::entries_mut(&mut self.modal);
        let coupling = self.coupling.as_mut();
        for mode in 0..count {
            let (_, rest) = entries.split_at_mut_checked(mode * count)?;
            let (row, later) = rest.split_at_mut_checked(count)?;
            let pivot = *row.get(mode)?;
            let positive = pivot > T::zero();
            if !positive || !pivot.is_finite() {
                return None;
            }
            let inverse = T::one() / pivot;
            *row.get_mut(mode)? = inverse;
            let (own, others) = coupling.get_mut(mode..)?.split_first_mut()?;
            let rows = later.chunks_exact_mut(count).zip(others.iter_mut());
            for (number, (next, place)) in rows.enumerate() {
                let number = mode + 1 + number;
                let share = inverse * *row.get(number)?;
                for (entry, above) in next.iter_mut().zip(row.iter()).skip(number) {
                    *entry -= share * *above;
                }
                subtract_scaled(place, share, own);
            }
        }
        // row by row, so that the sums stay in registers
        for (axis, row) in inertia.iter_mut().enumerate() {
            let mut left = *row;
            for (mode, own) in coupling.iter().enumerate() {
                let share = *entries.get(mode * count + mode)? * *own.get(axis)?;
                subtract_scaled(&mut left, share, own);
            }
            *row = left;
        }
        Some(())
    }

    /// Adds what acts at an end. `twists`: Φᵀ there; or takes it away, at the end of the body's own joint. Shape: M x 6.
    pub(crate) fn push(&mut self, force: &[T; 6], twists: &[[T; 6]], sign: T) {
        for (place, twist) in self.force.as_mut_slice().iter_mut().zip(twists) {
            *place += sign * dot(twist, force);
        }
    }

    /// Lets the modes go under the forces on them; takes out of the force on the frame what that costs.
    pub(crate) fn yield_to(&mut self, force: &mut [T; 6]) {
        let count = self.force.as_slice().len();
        let rows = V::entries_mut(&mut self.modal).chunks_exact(count.max(1));
        let forces = self.force.as_mut_slice();
        for (mode, (row, own)) in rows.zip(self.coupling.as_ref()).enumerate() {
            let Some(([first, ..], later)) =
                forces.split_at_mut_checked(mode).and_then(|(_, rest)| rest.split_at_mut_checked(1))
            else {
                return;
            };
            let (Some(inverse), Some(above)) = (row.get(mode), row.get(mode + 1..)) else { return };
            let amount = *inverse * *first;
            for (place, entry) in later.iter_mut().zip(above) {
                *place -= *entry * amount;
            }
            subtract_scaled(force, amount, own);
            *first = amount;
        }
    }

    /// Moves the modes with the end of the body's joint; from then on `force` is their accelerations.
    pub(crate) fn follow(&mut self, twist: &[T; 6]) {
        let count = self.force.as_slice().len();
        let entries = V::entries_mut(&mut self.modal);
        let amounts = self.force.as_mut_slice();
        for (mode, own) in self.coupling.as_ref().iter().enumerate().rev() {
            let Some(row) = entries.get(mode * count..(mode + 1) * count) else { return };
            let Some(([first, ..], later)) =
                amounts.split_at_mut_checked(mode).and_then(|(_, rest)| rest.split_at_mut_checked(1))
            else {
                return;
            };
            let (Some(inverse), Some(above)) = (row.get(mode), row.get(mode + 1..)) else { return };
            let mut met = dot(own, twist);
            for (amount, entry) in later.iter().zip(above) {
                met += *entry * *amount;
            }
            *first -= *inverse * met;
        }
    }

    /// Adds what the modes' accelerations do at an end, or takes it away. `twists`: Φᵀ there. Shape: M x 6.
    pub(crate) fn carry(&self, twist: &mut [T; 6], twists: &[[T; 6]], sign: T) {
        for (amount, own) in self.force.as_slice().iter().zip(twists) {
            add_scaled(twist, sign * *amount, own);
        }
    }
}
