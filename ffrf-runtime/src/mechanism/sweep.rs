//! Factors and solutions of a mechanism that is a tree.

use nalgebra::{RealField, Vector3};

use super::tree::Held;
use super::{
    Branch, Connection, Constraints, EvaluatedJoint, Freedom, JointPlace, Limb, LimbEnd, Plan, Storage,
};
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
fn held_by<T: RealField + Copy>(connection: &Connection<T>, rows: &Rows<T>) -> [Held<T>; 2] {
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
    [forces, Held::by(&moments, rotations)]
}

/// How many of the rows that hold a body, the first ones, hold translations.
fn held_translations<T: RealField + Copy>(connections: &[Connection<T>], branch: &Branch) -> usize {
    let connection = branch.joint.and_then(|number| connections.get(number));
    connection.map_or(0, |connection| connection.kind.held_translations())
}

type Motions<'f, T> = &'f mut [Option<Freedom<T>>];

/// The motions that the joint of a body leaves where it holds so many translations: those along, those about.
fn motions<'f, T>(
    freedoms: &'f mut [Option<Freedom<T>>],
    branch: &Branch,
    held_translations: usize,
) -> Option<(Motions<'f, T>, Motions<'f, T>)> {
    let own = freedoms.get_mut(branch.freedom..)?.get_mut(..branch.freedoms)?;
    own.split_at_mut_checked(3_usize.saturating_sub(held_translations))
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

/// Where a body is held.
struct Seat {
    /// The slot of its own end of the joint.
    root: Option<usize>,
    /// What holds it, if that is no ground.
    parent: Option<Parent>,
}

/// What holds a body.
struct Parent {
    /// Among the branches.
    place: usize,
    body: usize,
    /// The slot of its end of the joint.
    slot: usize,
}

fn seat(plan: &Plan<'_>, branch: &Branch) -> Option<Seat> {
    let Some(joint) = branch.joint else { return Some(Seat { root: None, parent: None }) };
    let [first, second] = plan.joints.get(joint)?.ends.each_ref().map(|end| end.as_ref().map(|end| end.slot));
    let (root, other) = if branch.is_second { (second, first) } else { (first, second) };
    let parent = match branch.parent {
        Some(place) => Some(Parent { place, body: plan.branches.get(place)?.body, slot: other? }),
        None => None,
    };
    Some(Seat { root, parent })
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
        let Seat { root, parent } = seat(&self.plan, branch)?;
        self.ports.port_mut(branch.body)?.close(limb, root)?;
        let held = match branch.joint {
            Some(number) => held_by(self.connections.get(number)?, &joints.get(number)?.as_ref()?.rows),
            None => [Held::nothing(); 2],
        };
        limb.hold(&held);
        let mut sound = is_sound(&held);
        let (along, about) = motions(freedoms, branch, held_translations(self.connections, branch))?;
        let [translations, rotations] = &held;
        for (place, free) in along.iter_mut().zip(&translations.free) {
            sound &= place.insert(Freedom::release::<0>(free, &mut limb.inertia)).is_sound();
        }
        for (place, free) in about.iter_mut().zip(&rotations.free) {
            sound &= place.insert(Freedom::release::<3>(free, &mut limb.inertia)).is_sound();
        }
        if let Some(Parent { place, body, slot }) = parent {
            before.get_mut(place)?.as_mut()?.bear(&limb.inertia, &limb.arm);
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
        let Seat { root, parent } = seat(&self.plan, branch)?;
        let held = held_translations(self.connections, branch);
        self.ports.port_mut(branch.body)?.yield_to(limb, root);
        if let Some(number) = branch.joint {
            let wanted = right.get(self.plan.joints.get(number)?.node)?;
            let (forces, moments) = wanted.split_at_checked(held)?;
            let sum = |duals: &[Vector3<T>; 3], wanted: &[T]| {
                duals.iter().zip(wanted).fold(Vector3::zeros(), |sum, (dual, wanted)| sum + dual * *wanted)
            };
            let [translations, rotations] = &limb.held;
            let (linear, angular) = (sum(translations, forces), sum(rotations, moments));
            limb.step =
                scaled(branch.sign(), &[linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]);
        }
        let (along, about) = motions(freedoms, branch, held)?;
        for freedom in along.iter_mut().flatten() {
            freedom.yield_to::<0>(&mut limb.force);
        }
        for freedom in about.iter_mut().flatten() {
            freedom.yield_to::<3>(&mut limb.force);
        }
        if let Some(Parent { place, body, slot }) = parent {
            let mut pull = scaled(-T::one(), &limb.resist(&limb.step));
            add(&mut pull, &limb.force);
            before.get_mut(place)?.as_mut()?.push(pull, &limb.arm);
            self.ports.port_mut(body)?.bear_force(slot, &pull);
        }
        Some(())
    }

    /// Moves a body with its parent and along its own motions; gives the multipliers of its joint.
    fn follow_tree(&mut self, index: usize, branch: &Branch) -> Option<()> {
        let Storage { limbs, freedoms, solution, .. } = &mut *self.storage;
        let (before, [place, ..]) = limbs.split_at_mut_checked(index)? else { return None };
        let limb = place.as_mut()?;
        let Seat { root, parent } = seat(&self.plan, branch)?;
        let held = held_translations(self.connections, branch);
        let mut twist = [T::zero(); 6];
        if let Some(Parent { place, body, slot }) = parent {
            twist = before.get(place)?.as_ref()?.twist_at(&limb.arm);
            self.ports.port(body)?.carry(slot, &mut twist);
        }
        if let Some(number) = branch.joint {
            add(&mut twist, &limb.step);
            // what acts on the body at its joint, less what it would take to move alone
            let mut wrench = scaled(-T::one(), &limb.resist(&twist));
            add(&mut wrench, &limb.force);
            let [x, y, z, r_x, r_y, r_z] = scaled(branch.sign(), &wrench);
            let (force, moment) = (Vector3::new(x, y, z), Vector3::new(r_x, r_y, r_z));
            let negative = solution.get_mut(self.plan.joints.get(number)?.node)?;
            *negative = [T::zero(); 6];
            let (forces, moments) = negative.split_at_mut_checked(held)?;
            let [translations, rotations] = &limb.held;
            for (place, dual) in forces.iter_mut().zip(translations) {
                *place = dual.dot(&force);
            }
            for (place, dual) in moments.iter_mut().zip(rotations) {
                *place = dual.dot(&moment);
            }
        }
        let (along, about) = motions(freedoms, branch, held)?;
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
