//! Accelerations, multipliers and corrections of a mechanism: one factorisation, several right-hand sides.

use nalgebra::RealField;

use super::projected::round_off;
use super::soft_rows::{attach_soft_rows, pull_soft_rows};
use super::standing::stands;
use super::{Connection, EvaluatedJoint, Freedom, Limb, Plan, Ports, Regularisation};
use crate::integrators::StepError;
use crate::joints::Joint;
use crate::six::{add, block_at, products, scaled, six_times, transpose};

/// The numbers of one evaluation of a mechanism; sizes as its plan says.
#[derive(Debug)]
pub struct Storage<'a, T: RealField + Copy> {
    /// Blocks of the matrix, which become those of its factors; zeros that nothing was written to are not there.
    pub blocks: &'a mut [Option<[[T; 6]; 6]>],
    /// Unknowns of each node: accelerations of frames and *negative* multipliers.
    pub solution: &'a mut [[T; 6]],
    /// Right-hand side; after a solve, the last correction.
    pub right: &'a mut [[T; 6]],
    /// μ of each row, at the place of its multiplier.
    pub shift: &'a mut [[T; 6]],
    /// Each joint, then each soft link; none before they are evaluated.
    pub joints: &'a mut [Option<EvaluatedJoint<T>>],
    /// What each friction that follows reactions exerts; as many as there are.
    pub efforts: &'a mut [T],
    /// The markers at both ends of each soft link; none in explicit evaluations.
    pub soft_markers: &'a mut [[usize; 2]],
    /// Each branch of a tree, none before it is factored.
    pub limbs: &'a mut [Option<Limb<T>>],
    /// The motions of all branches, likewise.
    pub freedoms: &'a mut [Option<Freedom<T>>],
}

impl<T: RealField + Copy> Storage<'_, T> {
    /// The joints that were evaluated, then the soft links.
    pub fn evaluated(&self) -> impl Iterator<Item = &EvaluatedJoint<T>> {
        self.joints.iter().flatten()
    }
}

/// Which level of the constraints a right-hand side corrects.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// Displacements that take the residual away.
    Position,
    /// Velocities that take the rate of the residual away.
    Velocity,
}

/// What the accelerations that are solved for do to the residuals g of the rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target<T = f64> {
    /// g̈ = -2 a ġ - b² g, where `gains` are 2 a and b² (Baumgarte); zero to keep ġ as it is. Units: 1/s and 1/s².
    Acceleration {
        /// 2 a and b².
        gains: [T; 2],
    },
    /// Correction of accelerations that act for this long on velocities: takes ġ away. Units: s.
    Velocity {
        /// What a change of the accelerations is multiplied by to change velocities.
        share: T,
    },
    /// As [`Constraints::take_aim`] has put it in the place of residuals.
    Aimed,
    /// Correction of accelerations that act so on places: takes g away. Units: s².
    Position {
        /// What a change of the accelerations is multiplied by to change places.
        share: T,
    },
}

/// A mechanism in one state: its bodies, joints and numbers.
pub struct Constraints<'a, 's, T: RealField + Copy> {
    /// Where everything stands.
    pub plan: Plan<'a>,
    /// The joints.
    pub connections: &'a [Connection<T>],
    /// The bodies.
    pub ports: &'a mut dyn Ports<T>,
    /// The numbers.
    pub storage: &'a mut Storage<'s, T>,
    /// Treatment of redundant rows.
    pub regularisation: Regularisation<T>,
    /// Whether bodies stand on their [supports](super::JointPlace::is_support), whose multipliers are then not found.
    pub supported: bool,
}

impl<T: RealField + Copy> Constraints<'_, '_, T> {
    /// Evaluates the joints: motion of their ends and rows. `drive` gives value, rate and acceleration for each joint.
    pub fn evaluate(&mut self, drive: &dyn Fn(usize) -> [T; 3]) {
        for (number, (connection, place)) in
            self.connections.iter().zip(self.storage.joints.iter_mut()).enumerate()
        {
            let EvaluatedJoint { rows, ends: [first, second] } = EvaluatedJoint::put(place);
            connection.first.put_motion(self.ports, first);
            connection.second.put_motion(self.ports, second);
            connection.kind.push_rows(rows, first, second, &drive(number));
        }
    }

    /// Factors the system in the state that was evaluated.
    ///
    /// Errors: a body or the system has no factors.
    pub fn factor(&mut self) -> Result<(), StepError> {
        if self.is_tree() {
            return self.factor_tree();
        }
        let share = self.regularisation.share;
        for index in 0..self.plan.bodies.len() {
            if self.ports.port_mut(index).is_some_and(|port| port.factor().is_err()) {
                return Err(self.blame());
            }
        }
        if self.supported {
            self.put_on_supports();
        }
        let Storage { blocks, shift: shifts, joints: evaluated, soft_markers, .. } = &mut *self.storage;
        for block in blocks.iter_mut() {
            *block = None;
        }
        for (index, place) in self.plan.bodies.iter().enumerate() {
            if let (Some(port), Some(block)) = (self.ports.port(index), block_at(blocks, place.diagonal)) {
                port.rigid_mass(block);
            }
        }
        let joints = self.plan.joints.iter().zip(self.connections).zip(evaluated.iter());
        for ((place, connection), joint) in joints {
            let Some(EvaluatedJoint { rows, .. }) = joint else { continue };
            let mut shift = [T::zero(); 6];
            if place.is_support && stands(self.ports, place) {
                if let Some(kept) = shifts.get_mut(place.node) {
                    *kept = shift;
                }
                continue;
            }
            for ((end, attachment), gradients) in
                place.ends.iter().zip([&connection.first, &connection.second]).zip(rows.gradients())
            {
                let Some(end) = end else { continue };
                let Some(port) = self.ports.port_mut(end.body) else { continue };
                let Some(block) = block_at(blocks, end.block.index) else { continue };
                let measured = (share > T::zero()).then_some(&mut shift);
                port.attach(end.slot, attachment.marker, rows.len(), gradients, block, measured);
                if end.block.transposed {
                    transpose(block);
                }
                if let Some(block) = block_at(blocks, place.diagonal) {
                    port.subtract_compliance(end.slot, end.slot, block);
                }
            }
            if let (true, Some(block)) = (share > T::zero(), block_at(blocks, place.diagonal)) {
                six_times!(K: {
                    shift[K] = share * (shift[K] - block[K][K]);
                    block[K][K] -= shift[K];
                });
                if let Some(kept) = shifts.get_mut(place.node) {
                    *kept = shift;
                }
            }
        }
        let hard = self.connections.len();
        if let (Some(places @ [_, ..]), Some(links)) = (self.plan.joints.get(hard..), evaluated.get(hard..)) {
            attach_soft_rows(places, links, soft_markers, self.ports, blocks);
        }
        for shared in self.plan.shared {
            let (rows, columns) = match shared.block.transposed {
                true => (shared.first, shared.second),
                false => (shared.second, shared.first),
            };
            if let (Some(port), Some(block)) =
                (self.ports.port(shared.body), block_at(blocks, shared.block.index))
            {
                port.subtract_compliance(rows, columns, block);
            }
        }
        self.place_kept_modes();
        let blocks = &mut *self.storage.blocks;
        self.plan.elimination.factor(blocks).ok_or_else(|| self.blame())
    }

    /// Why there are no factors: the first body that has none of its own.
    #[cold]
    pub(super) fn blame(&self) -> StepError {
        let amplitude = |body| self.ports.port(body)?.indefinite();
        let found = (0..self.plan.bodies.len()).find_map(|body| Some((body, amplitude(body)?)));
        found.map_or(StepError::MassNotPositive, |(body, amplitude)| StepError::BodyNotPositive {
            body,
            amplitude: nalgebra::try_convert(amplitude).unwrap_or(f64::NAN),
        })
    }

    /// Sets the blocks of modes that bodies keep as unknowns.
    fn place_kept_modes(&mut self) {
        let blocks = &mut *self.storage.blocks;
        for place in self.plan.modes {
            let Some(port) = self.ports.port(place.body) else { continue };
            if let Some(block) = block_at(blocks, place.diagonal) {
                port.modal_mass(place.first, place.first, block);
            }
            if let Some(block) = block_at(blocks, place.frame.index) {
                port.modal_coupling(place.first, block);
                if place.frame.transposed {
                    transpose(block);
                }
            }
        }
        for place in self.plan.modal_pairs {
            if let (Some(port), Some(block)) = (self.ports.port(place.body), block_at(blocks, place.block)) {
                port.modal_mass(place.rows, place.columns, block);
            }
        }
        for place in self.plan.modal_ends {
            let Some(port) = self.ports.port(place.body) else { continue };
            if let Some(block) = block_at(blocks, place.block.index) {
                port.modal_rows(place.slot, place.first, block);
                if place.block.transposed {
                    transpose(block);
                }
            }
        }
    }

    /// Accelerations of every body and multipliers, in the factored state.
    ///
    /// With accelerations subtracted (see [`ImplicitTerms`](super::ImplicitTerms)), what is found is their correction.
    pub fn accelerate(&mut self, target: Target<T>) {
        let is_tree = self.is_tree();
        if !is_tree {
            if self.supported {
                self.ask_of_supports(target);
            }
            self.take_forces();
        }
        for number in 0..self.connections.len() {
            self.put_wanted(number, target, !is_tree);
        }
        if is_tree {
            self.solve_tree(true);
            return;
        }
        let hard = self.connections.len();
        let Storage { joints, soft_markers, right, .. } = &mut *self.storage;
        if let (Some(places @ [_, ..]), Some(links)) = (self.plan.joints.get(hard..), joints.get(hard..)) {
            pull_soft_rows(places, links, soft_markers, self.ports, right);
        }
        self.solve(self.regularisation.refinements);
    }

    /// Takes the forces on bodies as right-hand sides.
    fn take_forces(&mut self) {
        for (index, place) in self.plan.bodies.iter().enumerate() {
            let Some(port) = self.ports.port_mut(index) else { continue };
            if let Some(right) = self.storage.right.get_mut(place.node) {
                *right = port.reduced_force();
            }
        }
        for place in self.plan.modes {
            let Some(port) = self.ports.port(place.body) else { continue };
            if let Some(right) = self.storage.right.get_mut(place.node) {
                *right = port.modal_force(place.first);
            }
        }
    }

    /// Stores what takes the residuals of positions away as they are now, for rows that are evaluated anew before
    /// [`take_aim`](Self::take_aim). `share`: what a change of the unknowns is multiplied by to change places.
    pub fn aim(&mut self, share: T) {
        for (place, joint) in self.plan.joints.iter().zip(self.storage.joints.iter()) {
            if let (Some(right), Some(joint)) = (self.storage.right.get_mut(place.node), joint) {
                *right = scaled(-T::one() / share, joint.rows.residuals());
            }
        }
    }

    /// Puts what [`aim`](Self::aim) has stored in the place of the residuals of rows that were evaluated anew since.
    pub fn take_aim(&mut self) {
        for (place, joint) in self.plan.joints.iter().zip(self.storage.joints.iter_mut()) {
            if let (Some(right), Some(joint)) = (self.storage.right.get(place.node), joint) {
                joint.rows.set_residuals(*right);
            }
        }
    }

    /// Displacements or changes of velocity of least kinetic energy that take the residuals of a level away, to first order.
    pub fn correct(&mut self, level: Level) {
        self.storage.right.fill([T::zero(); 6]);
        for index in 0..self.plan.bodies.len() {
            if let Some(port) = self.ports.port_mut(index) {
                port.without_force();
            }
        }
        let target = match level {
            Level::Position => Target::Position { share: T::one() },
            Level::Velocity => Target::Velocity { share: T::one() },
        };
        if self.supported {
            self.ask_of_supports(target);
            for (index, place) in self.plan.bodies.iter().enumerate() {
                if let (Some(port), Some(right)) =
                    (self.ports.port(index), self.storage.right.get_mut(place.node))
                {
                    *right = port.unforced();
                }
            }
        }
        // soft rows resist corrections, and ask for none
        for number in 0..self.connections.len() {
            self.put_wanted(number, target, false);
        }
        if self.is_tree() {
            self.solve_tree(false);
        } else {
            self.solve(self.regularisation.refinements_of_corrections());
        }
    }

    fn solve(&mut self, refinements: usize) {
        let Storage { blocks, solution, right, shift, .. } = &mut *self.storage;
        let elimination = &self.plan.elimination;
        let (leading, all) = (elimination.leading, elimination.steps.len());
        copy(solution, right);
        elimination.solve_forwards(0, blocks, solution);
        elimination.solve_backwards(leading..all, blocks, solution);
        // what μ makes the rows leave over, again and again: multipliers are negative here
        for refinement in 0..refinements {
            for (node, (right, solution)) in right.iter_mut().zip(solution.iter()).enumerate() {
                let last = if refinement == 0 { solution } else { &*right };
                *right = match shift.get(node) {
                    Some(shift) => scaled(-T::one(), &products(shift, last)),
                    None => [T::zero(); 6],
                };
            }
            elimination.solve_forwards(leading, blocks, right);
            elimination.solve_backwards(leading..all, blocks, right);
            for node in elimination.nodes_from(leading) {
                if let (Some(sum), Some(change)) = (solution.get_mut(node), right.get(node)) {
                    add(sum, change);
                }
            }
            if self.regularisation.is_met(shift, solution, right) {
                break;
            }
        }
        elimination.solve_backwards(0..leading, blocks, solution);
        for (index, place) in self.plan.bodies.iter().enumerate() {
            if let (Some(port), Some(rigid)) = (self.ports.port_mut(index), solution.get(place.node)) {
                port.finish(rigid);
            }
        }
        for place in self.plan.modes {
            if let (Some(port), Some(modal)) = (self.ports.port_mut(place.body), solution.get(place.node)) {
                port.finish_modes(place.first, modal);
            }
        }
        for place in self.plan.joints {
            let Some(multipliers) = solution.get(place.node) else { continue };
            for end in place.ends.iter().flatten() {
                if let Some(port) = self.ports.port_mut(end.body).filter(|port| port.has_modes()) {
                    port.follow(end.slot, multipliers);
                }
            }
        }
    }

    /// Adds the resulting change of velocities to those of the joints' ends, which are where they were; their biases stay
    /// behind.
    pub(super) fn follow_velocities(&mut self) {
        for (connection, joint) in self.connections.iter().zip(self.storage.joints.iter_mut()) {
            let Some(joint) = joint else { continue };
            for (attachment, end) in [&connection.first, &connection.second].into_iter().zip(&mut joint.ends)
            {
                let Some(port) = attachment.body.and_then(|body| self.ports.port(body)) else { continue };
                let [linear, angular] = port.resulting_twist(attachment.marker);
                end.velocity += linear;
                end.angular_velocity += angular;
            }
        }
    }

    /// Residuals of positions and of velocities that no correction makes smaller: the round-off of what they are
    /// differences of.
    pub(super) fn round_off(&self) -> [T; 2] {
        let mut largest = [T::one(); 2];
        let hard = self.storage.joints.iter().take(self.connections.len()).flatten();
        for end in hard.flat_map(|joint| &joint.ends) {
            let velocities = end.velocity.iter().chain(end.angular_velocity.iter());
            largest[0] = end.position.iter().fold(largest[0], |largest, entry| largest.max(entry.abs()));
            largest[1] = velocities.fold(largest[1], |largest, entry| largest.max(entry.abs()));
        }
        largest.map(round_off)
    }

    /// The largest residual of positions and of velocities, and the joint with the largest position residual.
    pub fn residuals(&self) -> ([T; 2], usize) {
        let mut largest = ([T::zero(); 2], 0);
        let evaluated = self.storage.joints.iter().take(self.connections.len());
        for (joint, evaluated) in evaluated.enumerate() {
            let Some(EvaluatedJoint { rows, ends }) = evaluated else { continue };
            for (position, velocity) in rows.residuals().iter().zip(&rows.velocities(ends)) {
                let (position, velocity) = (position.abs(), velocity.abs());
                if is_worse(position, largest.0[0]) {
                    largest.0[0] = position;
                    largest.1 = joint;
                }
                if is_worse(velocity, largest.0[1]) {
                    largest.0[1] = velocity;
                }
            }
        }
        largest
    }
}

/// Whether a residual is larger than the largest so far; the first that is not finite is larger than all.
pub(super) fn is_worse<T: RealField + Copy>(residual: T, largest: T) -> bool {
    residual > largest || (largest.is_finite() && !residual.is_finite())
}

/// Copies as many as both have.
fn copy<T: Copy>(to: &mut [T], from: &[T]) {
    for (place, value) in to.iter_mut().zip(from) {
        *place = *value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_residual_that_is_not_a_number_stays_the_largest() {
        let largest = |residuals: [f64; 4]| {
            residuals.into_iter().fold(0.0, |worst, found| if is_worse(found, worst) { found } else { worst })
        };
        assert_eq!(largest([1.0, 3.0, 2.0, 0.0]), 3.0);
        assert!(largest([1.0, f64::NAN, 2.0, f64::INFINITY]).is_nan());
    }
}
