//! Factors and solutions of a mechanism that is a tree.

use nalgebra::{RealField, Vector3};

use super::beyond::beyond;
use super::tree::{Parent, Seat, hold};
use super::{Branch, Connection, Constraints, Freedom, Limb, LimbEnd, Plan, Storage};
use crate::integrators::StepError;
use crate::six::{add, scaled};

/// Three numbers of each of the rows of a joint from `start` on, at its second end: of forces, or of moments.
#[inline(always)]
fn rows_from<T: RealField + Copy>([x, y, z]: [&[T; 6]; 3], start: usize) -> [Vector3<T>; 3] {
    let at = |numbers: &[T; 6], row: usize| numbers.get(row).copied().unwrap_or(T::zero());
    [start, start + 1, start + 2].map(|row| Vector3::new(at(x, row), at(y, row), at(z, row)))
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

/// Sets where a body is held, in its place.
#[inline(always)]
fn take_seat(seat: &mut Seat, plan: &Plan<'_>, branch: &Branch) -> Option<()> {
    let Some(joint) = branch.joint else { return Some(()) };
    let [first, second] = &plan.joints.get(joint)?.ends;
    let (root, other) = if branch.is_second { (second, first) } else { (first, second) };
    seat.root = root.as_ref().map(|end| end.slot);
    if let (Some(place), Some(end)) = (branch.parent, other) {
        seat.parent = Some(Parent { place, body: end.body, slot: end.slot });
    }
    Some(())
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
        take_seat(&mut limb.seat, &self.plan, branch)?;
        if let Some(number) = branch.joint {
            let (connection, joint) = (self.connections.get(number)?, joints.get(number)?.as_ref()?);
            let (own, other) = match branch.is_second {
                true => (&connection.second, &connection.first),
                false => (&connection.first, &connection.second),
            };
            let beyond_own = beyond(connection, joint, branch.is_second);
            let end = LimbEnd { slot: limb.seat.root?, marker: own.marker, beyond: beyond_own };
            limb.root = self.ports.port_mut(branch.body)?.reach(&end);
            if let Some(Parent { place, body, slot }) = limb.seat.parent {
                let beyond_other = beyond(connection, joint, !branch.is_second);
                let end = LimbEnd { slot, marker: other.marker, beyond: beyond_other };
                limb.arm = self.ports.port_mut(body)?.reach(&end) - before.get(place)?.as_ref()?.root;
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
        let Seat { root, parent } = limb.seat;
        if limb.has_modes {
            self.ports.port_mut(branch.body)?.close(limb, root)?;
        }
        let (along, about) = motions(freedoms, branch, held_translations(self.connections, branch))?;
        let Limb { inertia, held: [forces, moments], holds_point, .. } = limb;
        let mut sound = true;
        let (mut along, mut about) = (along.iter_mut(), about.iter_mut());
        match branch.joint {
            None => {
                for free in [Vector3::x(), Vector3::y(), Vector3::z()] {
                    sound &= Freedom::put::<0>(along.next(), &free, inertia);
                }
                for free in [Vector3::x(), Vector3::y(), Vector3::z()] {
                    sound &= Freedom::put::<3>(about.next(), &free, inertia);
                }
            }
            Some(number) => {
                let (connection, joint) = (self.connections.get(number)?, joints.get(number)?.as_ref()?);
                let [_, [x, y, z, r_x, r_y, r_z]] = joint.rows.gradients();
                let translations = connection.kind.held_translations();
                *holds_point = connection.kind.holds_point();
                if !*holds_point {
                    let rows = rows_from([x, y, z], 0);
                    let apart = hold(&rows, translations, forces, |free| {
                        sound &= Freedom::put::<0>(along.next(), free, inertia);
                    });
                    sound &= apart;
                }
                let rows = rows_from([r_x, r_y, r_z], translations);
                let apart = hold(&rows, joint.rows.len().saturating_sub(translations), moments, |free| {
                    sound &= Freedom::put::<3>(about.next(), free, inertia);
                });
                sound &= apart;
            }
        }
        if let Some(Parent { place, body, slot }) = parent {
            let parent = before.get_mut(place)?.as_mut()?;
            parent.bear(&limb.inertia, &limb.arm);
            if parent.has_modes {
                self.ports.port_mut(body)?.bear(slot, &limb.inertia, &limb.arm);
            }
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
        let Seat { root, parent } = limb.seat;
        let held = held_translations(self.connections, branch);
        if limb.has_modes {
            self.ports.port_mut(branch.body)?.yield_to(limb, root);
        }
        if let Some(number) = branch.joint {
            let wanted = right.get(self.plan.joints.get(number)?.node)?;
            let (forces, moments) = wanted.split_at_checked(held)?;
            let sum = |duals: &[Vector3<T>; 3], wanted: &[T]| {
                duals.iter().zip(wanted).fold(Vector3::zeros(), |sum, (dual, wanted)| sum + dual * *wanted)
            };
            let [translations, rotations] = &limb.held;
            let linear = match forces {
                [x, y, z] if limb.holds_point => Vector3::new(*x, *y, *z),
                _ => sum(translations, forces),
            };
            let angular = sum(rotations, moments);
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
            let parent = before.get_mut(place)?.as_mut()?;
            parent.push(pull, &limb.arm);
            if parent.has_modes {
                self.ports.port_mut(body)?.bear_force(slot, &pull);
            }
        }
        Some(())
    }

    /// Moves a body with its parent and along its own motions; gives the multipliers of its joint.
    fn follow_tree(&mut self, index: usize, branch: &Branch) -> Option<()> {
        let Storage { limbs, freedoms, solution, .. } = &mut *self.storage;
        let (before, [place, ..]) = limbs.split_at_mut_checked(index)? else { return None };
        let limb = place.as_mut()?;
        let Seat { root, parent } = limb.seat;
        let held = held_translations(self.connections, branch);
        let mut twist = [T::zero(); 6];
        if let Some(Parent { place, body, slot }) = parent {
            let parent = before.get(place)?.as_ref()?;
            twist = parent.twist_at(&limb.arm);
            if parent.has_modes {
                // a copy, so that the twist of a rigid one stays in registers
                let mut carried = twist;
                self.ports.port(body)?.carry(slot, &mut carried);
                twist = carried;
            }
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
            match forces {
                [x, y, z] if limb.holds_point => [*x, *y, *z] = force.into(),
                _ => {
                    for (place, dual) in forces.iter_mut().zip(translations) {
                        *place = dual.dot(&force);
                    }
                }
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
