//! Factors and solutions of a mechanism that is a tree.

use nalgebra::{RealField, Vector3};

use super::tree::Held;
use super::{Branch, Connection, Constraints, EvaluatedJoint, Freedom, JointPlace, Limb, LimbEnd, Storage};
use crate::integrators::StepError;
use crate::relations::Rows;
use crate::six::{add, scaled};

/// Whether motions stay apart from the rows of one joint.
fn is_sound<T: RealField + Copy>(held: &[Held<T>; 2]) -> bool {
    let duals = held.iter().flat_map(|held| &held.duals);
    duals.fold(T::zero(), |sum, dual| sum + dual.sum()).is_finite()
}

/// What the rows of a joint hold at its second end: translations, rotations.
#[inline]
fn held_by<T: RealField + Copy>(connection: &Connection<T>, rows: &Rows<T>) -> ([Held<T>; 2], [usize; 2]) {
    let translations = connection.kind.held_translations();
    let rotations = rows.len().saturating_sub(translations);
    let [_, [x, y, z, r_x, r_y, r_z]] = rows.gradients();
    let vector = |[x, y, z]: [&[T; 6]; 3], row: usize| {
        let at = |numbers: &[T; 6]| numbers.get(row).copied().unwrap_or(T::zero());
        Vector3::new(at(x), at(y), at(z))
    };
    let forces = if connection.kind.holds_point() {
        Held::point()
    } else {
        Held::by(&[0, 1, 2].map(|row| vector([x, y, z], row)), translations)
    };
    let moments = [0, 1, 2].map(|row| vector([r_x, r_y, r_z], translations + row));
    ([forces, Held::by(&moments, rotations)], [translations, rotations])
}

/// The end of a joint on a body, and how far its rows act beyond that.
///
/// Both ends are seen where the second one is: rows that hold a point or a distance do not ask where, and the others have the
/// moment of that distance at their first end.
fn end_of<T: RealField + Copy>(
    connection: &Connection<T>,
    joint: &EvaluatedJoint<T>,
    place: &JointPlace,
    second: bool,
) -> Option<LimbEnd<T>> {
    let [first_end, second_end] = &place.ends;
    let (end, attachment, beyond) = match second {
        true => (second_end, &connection.second, Vector3::zeros()),
        false if connection.kind.holds_point() => (first_end, &connection.first, Vector3::zeros()),
        false => (first_end, &connection.first, joint.ends[1].position - joint.ends[0].position),
    };
    end.as_ref().map(|end| LimbEnd { slot: end.slot, marker: attachment.marker, beyond })
}

/// The slot of one end of a joint.
fn slot_of(place: &JointPlace, second: bool) -> Option<usize> {
    let [first_end, second_end] = &place.ends;
    (if second { second_end } else { first_end }).as_ref().map(|end| end.slot)
}

impl<T: RealField + Copy> Constraints<'_, '_, T> {
    /// Whether joints close no loop, and are swept over.
    #[inline]
    pub(super) fn is_tree(&self) -> bool {
        !self.plan.branches.is_empty()
    }

    /// What every body with all that hangs on it resists the motion of its joint with.
    pub(super) fn factor_tree(&mut self) -> Result<(), StepError> {
        for (index, branch) in self.plan.branches.iter().enumerate() {
            if self.grow(index, branch).is_none() {
                return Err(self.blame_tree());
            }
        }
        for (index, branch) in self.plan.branches.iter().enumerate().rev() {
            if self.release(index, branch) != Some(true) {
                return Err(self.blame_tree());
            }
        }
        Ok(())
    }

    /// Puts a body where it stands in the tree, with nothing on it.
    fn grow(&mut self, index: usize, branch: &Branch) -> Option<()> {
        let Storage { joints, limbs, .. } = &mut *self.storage;
        let (before, [place, ..]) = limbs.split_at_mut_checked(index)? else { return None };
        let limb = place.get_or_insert_with(Limb::empty);
        limb.root = Vector3::zeros();
        if let Some(number) = branch.joint {
            let (connection, joint, place) =
                (self.connections.get(number)?, joints.get(number)?.as_ref()?, self.plan.joints.get(number)?);
            let end = end_of(connection, joint, place, branch.is_second)?;
            limb.root = self.ports.port_mut(branch.body)?.reach(&end);
            if let Some(parent) = branch.parent {
                let end = end_of(connection, joint, place, !branch.is_second)?;
                let body = self.plan.branches.get(parent)?.body;
                limb.arm = self.ports.port_mut(body)?.reach(&end) - before.get(parent)?.as_ref()?.root;
            }
        }
        self.ports.port_mut(branch.body)?.resist(limb);
        Some(())
    }

    /// Takes the motions that its joint leaves out of a body, and hangs the rest on its parent.
    fn release(&mut self, index: usize, branch: &Branch) -> Option<bool> {
        let Storage { joints, limbs, freedoms, .. } = &mut *self.storage;
        let (before, [place, ..]) = limbs.split_at_mut_checked(index)? else { return None };
        let limb = place.as_mut()?;
        let places = freedoms.get_mut(branch.freedom..)?;
        let mut sound = true;
        let of_joint = branch.joint.and_then(|number| self.plan.joints.get(number));
        let root = of_joint.and_then(|place| slot_of(place, branch.is_second));
        self.ports.port_mut(branch.body)?.close(limb, root)?;
        let Some(number) = branch.joint else {
            // a free body: all six
            let [translations, rotations] = [Held::by(&[Vector3::zeros(); 3], 0); 2];
            for (place, free) in places.iter_mut().zip(&translations.free) {
                sound &= place.insert(Freedom::release::<0>(free, &mut limb.inertia)).is_sound();
            }
            for (place, free) in places.iter_mut().skip(3).zip(&rotations.free) {
                sound &= place.insert(Freedom::release::<3>(free, &mut limb.inertia)).is_sound();
            }
            return Some(sound);
        };
        let (connection, joint) = (self.connections.get(number)?, joints.get(number)?.as_ref()?);
        let (held, [translations, rotations]) = held_by(connection, &joint.rows);
        sound &= is_sound(&held);
        limb.hold(&held);
        let (along, about) = places.split_at_mut_checked(3_usize.saturating_sub(translations))?;
        for (place, free) in along.iter_mut().zip(&held[0].free) {
            sound &= place.insert(Freedom::release::<0>(free, &mut limb.inertia)).is_sound();
        }
        let count = 3_usize.saturating_sub(rotations);
        for (place, free) in about.iter_mut().take(count).zip(&held[1].free) {
            sound &= place.insert(Freedom::release::<3>(free, &mut limb.inertia)).is_sound();
        }
        if let Some(parent) = branch.parent {
            before.get_mut(parent)?.as_mut()?.bear(&limb.inertia, &limb.arm);
            let body = self.plan.branches.get(parent)?.body;
            let slot = slot_of(of_joint?, !branch.is_second)?;
            self.ports.port_mut(body)?.bear(slot, &limb.inertia, &limb.arm);
        }
        Some(sound)
    }

    /// Motions of every body and negative multipliers, from what is wanted of each joint's rows in `right`.
    pub(super) fn solve_tree(&mut self, with_forces: bool) {
        for (branch, limb) in self.plan.branches.iter().zip(self.storage.limbs.iter_mut()) {
            let (Some(limb), Some(port)) = (limb, self.ports.port_mut(branch.body)) else { continue };
            port.force_on(limb, with_forces);
        }
        for (index, branch) in self.plan.branches.iter().enumerate().rev() {
            let _ = self.pull(index, branch);
        }
        for (index, branch) in self.plan.branches.iter().enumerate() {
            let _ = self.follow_tree(index, branch);
        }
    }

    /// Lets a body go along the motions that its joint leaves, and hands on what it pulls its parent with.
    fn pull(&mut self, index: usize, branch: &Branch) -> Option<()> {
        let Storage { limbs, freedoms, right, .. } = &mut *self.storage;
        let (before, [place, ..]) = limbs.split_at_mut_checked(index)? else { return None };
        let limb = place.as_mut()?;
        let freedoms = freedoms.get_mut(branch.freedom..)?;
        let (mut along, mut count) = (3, 6);
        let of_joint = branch.joint.and_then(|number| self.plan.joints.get(number));
        let root = of_joint.and_then(|place| slot_of(place, branch.is_second));
        self.ports.port_mut(branch.body)?.yield_to(limb, root);
        if let Some(number) = branch.joint {
            let (connection, place) = (self.connections.get(number)?, self.plan.joints.get(number)?);
            let held = connection.kind.held_translations();
            (along, count) = (3_usize.saturating_sub(held).min(branch.freedoms), branch.freedoms);
            let wanted = right.get(place.node)?;
            let (forces, moments) = (wanted.iter(), wanted.iter().skip(held));
            let sum = |duals: &[Vector3<T>; 3], wanted: &mut dyn Iterator<Item = &T>| {
                duals.iter().zip(wanted).fold(Vector3::zeros(), |sum, (dual, wanted)| sum + dual * *wanted)
            };
            let [translations, rotations] = &limb.held;
            let (linear, angular) =
                (sum(translations, &mut forces.take(held)), sum(rotations, &mut { moments }));
            let sign = if branch.is_second { T::one() } else { -T::one() };
            limb.step = scaled(sign, &[linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]);
        }
        let (along, about) = freedoms.get_mut(..count)?.split_at_mut_checked(along)?;
        for freedom in along.iter_mut().flatten() {
            freedom.yield_to::<0>(&mut limb.force);
        }
        for freedom in about.iter_mut().flatten() {
            freedom.yield_to::<3>(&mut limb.force);
        }
        if let Some(parent) = branch.parent {
            let mut pull = scaled(-T::one(), &limb.resist(&limb.step));
            add(&mut pull, &limb.force);
            before.get_mut(parent)?.as_mut()?.push(pull, &limb.arm);
            let (body, slot) = (self.plan.branches.get(parent)?.body, slot_of(of_joint?, !branch.is_second)?);
            self.ports.port_mut(body)?.bear_force(slot, &pull);
        }
        Some(())
    }

    /// Moves a body with its parent and along its own motions; gives the multipliers of its joint.
    fn follow_tree(&mut self, index: usize, branch: &Branch) -> Option<()> {
        let Storage { limbs, freedoms, solution, .. } = &mut *self.storage;
        let (before, [place, ..]) = limbs.split_at_mut_checked(index)? else { return None };
        let limb = place.as_mut()?;
        let freedoms = freedoms.get_mut(branch.freedom..)?;
        let (mut along, mut count) = (3, 6);
        let of_joint = branch.joint.and_then(|number| self.plan.joints.get(number));
        let root = of_joint.and_then(|place| slot_of(place, branch.is_second));
        let mut twist = [T::zero(); 6];
        if let Some(parent) = branch.parent {
            twist = before.get(parent)?.as_ref()?.twist_at(&limb.arm);
            let (body, slot) = (self.plan.branches.get(parent)?.body, slot_of(of_joint?, !branch.is_second)?);
            self.ports.port(body)?.carry(slot, &mut twist);
        }
        if let Some(number) = branch.joint {
            let (connection, place) = (self.connections.get(number)?, self.plan.joints.get(number)?);
            let held = connection.kind.held_translations();
            (along, count) = (3_usize.saturating_sub(held).min(branch.freedoms), branch.freedoms);
            add(&mut twist, &limb.step);
            // what acts on the body at its joint, less what it would take to move alone
            let mut wrench = scaled(-T::one(), &limb.resist(&twist));
            add(&mut wrench, &limb.force);
            let sign = if branch.is_second { T::one() } else { -T::one() };
            let [x, y, z, r_x, r_y, r_z] = scaled(sign, &wrench);
            let (force, moment) = (Vector3::new(x, y, z), Vector3::new(r_x, r_y, r_z));
            let negative = solution.get_mut(place.node)?;
            *negative = [T::zero(); 6];
            let [translations, rotations] = &limb.held;
            for (place, dual) in negative.iter_mut().take(held).zip(translations) {
                *place = dual.dot(&force);
            }
            for (place, dual) in negative.iter_mut().skip(held).zip(rotations) {
                *place = dual.dot(&moment);
            }
        }
        let (along, about) = freedoms.get(..count)?.split_at_checked(along)?;
        for freedom in about.iter().flatten().rev() {
            freedom.follow::<3>(&mut twist);
        }
        for freedom in along.iter().flatten().rev() {
            freedom.follow::<0>(&mut twist);
        }
        limb.twist = twist;
        self.ports.port_mut(branch.body)?.move_with(limb, root);
        Some(())
    }

    /// Why there are no factors: the first body that has none of its own.
    #[cold]
    fn blame_tree(&mut self) -> StepError {
        for index in 0..self.plan.bodies.len() {
            if let Some(port) = self.ports.port_mut(index) {
                // what fails here is named by what comes next
                let _ = port.factor();
            }
        }
        self.blame()
    }
}
