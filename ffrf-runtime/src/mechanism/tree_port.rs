//! A body in a tree, as the sweep over the tree sees it.

use nalgebra::{RealField, Vector3};

use super::{Limb, LimbEnd};

/// One body of a tree in one state. A root is the end of the joint that holds the body, or its frame origin if it is free; a slot
/// says which of the ends of joints on the body an end is.
pub trait TreePort<T: RealField + Copy> {
    /// From the origin of the body's frame to an end of a joint in a tree, which the modes move from now on. Shape: 3. Units: m.
    /// Frame: inertial.
    fn reach(&mut self, end: &LimbEnd<T>) -> Vector3<T>;
    /// Prepares deformed quantities, and sets what the body alone resists motions of its frame with, seen at its root: instead
    /// of [`Port::factor`](super::Port::factor).
    fn resist(&mut self, limb: &mut Limb<T>);
    /// Lets the modes bear what hangs at an end, `arm` from the root. Shape: 6 x 6.
    fn bear(&mut self, slot: usize, inertia: &[[T; 6]; 6], arm: &Vector3<T>);
    /// Takes the modes out of what motions of the root meet. `root`: the slot of the end there. `None` if a mode meets nothing.
    fn close(&mut self, limb: &mut Limb<T>, root: Option<usize>) -> Option<()>;
    /// Sets the force on a body in a tree, or none.
    fn force_on(&mut self, limb: &mut Limb<T>, with_forces: bool);
    /// Lets the modes bear a force at an end.
    fn bear_force(&mut self, slot: usize, force: &[T; 6]);
    /// Takes out of a force what moves the modes. `root`: see [`close`](Self::close).
    fn yield_to(&mut self, limb: &mut Limb<T>, root: Option<usize>);
    /// Takes the motion of a limb's root as the result, and leaves that of the frame there. `root`: see [`close`](Self::close).
    fn move_with(&mut self, limb: &mut Limb<T>, root: Option<usize>);
    /// Adds what the modes do at an end.
    fn carry(&self, slot: usize, twist: &mut [T; 6]);
}
