//! Accelerations, multipliers and corrections of a mechanism: one factorisation, several right-hand sides.

use nalgebra::RealField;

use super::{Connection, Plan, Ports};
use crate::body::{MarkerMotion, Wrench};
use crate::integrators::StepError;
use crate::joints::Joint;
use crate::relations::{MOST_ROWS, Rows};

/// How redundant rows are dealt with: the proximal method, exact for consistent redundant rows, reactions of least norm.
///
/// The factored matrix has μ subtracted from the diagonal of the rows, and a fixed number of refinements takes its effect
/// out again; since each begins with what the equations leave over, they also take out what an elimination without pivots
/// loses. Source: Carpentier, Budhiraja, Mansard, Proximal and sparse resolution of constrained dynamic equations,
/// RSS 2021.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regularisation<T = f64> {
    /// μ relative to the compliance that each row meets. Units: 1.
    pub share: T,
    /// Number of refinements.
    pub refinements: usize,
}

impl<T: RealField + Copy> Regularisation<T> {
    /// For mechanisms whose joints close loops: 1e-9 and two refinements in double precision, 1e-3 and three in single.
    ///
    /// Measured on a four-bar linkage that passes its singular position: these equal an exact solution there.
    pub fn of_loops() -> Self {
        let share = if T::default_epsilon() < nalgebra::convert(1e-10) { 1e-9 } else { 1e-3 };
        let refinements = if share < 1e-6 { 2 } else { 3 };
        Self { share: nalgebra::convert(share), refinements }
    }

    /// For trees, whose rows are never redundant: nothing is added, nothing to refine.
    pub fn of_trees() -> Self {
        Self { share: T::zero(), refinements: 0 }
    }
}

/// The numbers of one evaluation of a mechanism; sizes as its plan says.
#[derive(Debug)]
pub struct Storage<'a, T: RealField + Copy> {
    /// Entries of the matrix, which become those of its factors; then once more those of the matrix, which stay.
    pub values: &'a mut [T],
    /// Unknowns: accelerations of frames and *negative* multipliers.
    pub solution: &'a mut [T],
    /// Right-hand side; after a solve, what the equations leave over before the last correction.
    pub right: &'a mut [T],
    /// μ of each row, at the place of its multiplier, while factoring; corrections of the solution while solving.
    pub shift: &'a mut [T],
    /// Rows of each joint.
    pub rows: &'a mut [Rows<T>],
    /// What each friction that follows reactions exerts; as many as there are.
    pub efforts: &'a mut [T],
    /// Motion of both ends of each joint.
    pub ends: &'a mut [[MarkerMotion<T>; 2]],
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
}

impl<T: RealField + Copy> Constraints<'_, '_, T> {
    /// Evaluates the joints: motion of their ends and rows. `drive` gives value, rate and acceleration for each joint.
    pub fn evaluate(&mut self, drive: &dyn Fn(usize) -> [T; 3]) {
        let storage = self.storage.rows.iter_mut().zip(self.storage.ends.iter_mut());
        for (joint, (connection, (rows, ends))) in self.connections.iter().zip(storage).enumerate() {
            *ends = [connection.first.motion(self.ports), connection.second.motion(self.ports)];
            *rows = connection.kind.rows(&ends[0], &ends[1], &drive(joint));
        }
    }

    /// Factors the system in the state that was evaluated. Returns the smallest relative pivot.
    ///
    /// Errors: a body or the system has no factors.
    pub fn factor(&mut self) -> Result<T, StepError> {
        halves(self.storage.values).0.fill(T::zero());
        for (index, place) in self.plan.bodies.iter().enumerate() {
            let Some(port) = self.ports.port_mut(index) else { continue };
            port.factor()?;
            for (i, row) in port.rigid_mass().iter().enumerate() {
                for (j, entry) in row.iter().enumerate() {
                    set(self.storage.values, place.diagonal + 6 * i + j, *entry);
                }
            }
        }
        for (joint, place) in self.plan.joints.iter().enumerate() {
            self.attach(joint, place);
        }
        for shared in self.plan.shared {
            let Some(port) = self.ports.port(shared.body) else { continue };
            for i in 0..shared.first.1 {
                for j in 0..shared.second.1 {
                    let compliance = port.compliance(shared.first.0 + i, shared.second.0 + j);
                    add(self.storage.values, shared.block.entry(i, j), -compliance);
                }
            }
        }
        let (factors, matrix) = halves(self.storage.values);
        if self.regularisation.refinements > 0 {
            copy(matrix, factors);
        }
        if self.regularisation.share > T::zero() {
            for place in self.plan.joints {
                for k in 0..place.rows {
                    let shift = get(self.storage.shift, place.unknowns + k);
                    add(factors, place.diagonal + (place.rows + 1) * k, -shift);
                }
            }
        }
        self.plan.elimination.factor(factors).ok_or(StepError::MassNotPositive)
    }

    /// The rows of one joint: their effects on frames, the compliance of modes, and μ.
    fn attach(&mut self, joint: usize, place: &super::JointPlace) {
        let Some(connection) = self.connections.get(joint) else { return };
        let Some(rows) = self.storage.rows.get(joint).copied() else { return };
        for (side, end) in place.ends.iter().enumerate() {
            let Some(end) = end else { continue };
            let marker = if side == 0 { connection.first.marker } else { connection.second.marker };
            let diagonal = self.plan.bodies.get(end.body).map_or(0, |body| body.diagonal);
            let Some(port) = self.ports.port_mut(end.body) else { continue };
            let mut gradients = [Wrench::zero(); MOST_ROWS];
            for (gradient, row) in gradients.iter_mut().zip(rows.as_slice()) {
                *gradient = if side == 0 { row.first } else { row.second };
            }
            let gradients = gradients.get(..rows.as_slice().len()).unwrap_or(&[]);
            let mut effects = [[T::zero(); 6]; MOST_ROWS];
            port.attach(end.slot, marker, gradients, &mut effects);
            for (k, effect) in effects.iter().enumerate().take(gradients.len()) {
                for (i, entry) in effect.iter().enumerate() {
                    add(self.storage.values, end.block.entry(k, i), *entry);
                }
            }
            if port.has_modes() {
                for i in 0..place.rows {
                    for j in 0..=i {
                        let compliance = port.compliance(end.slot + i, end.slot + j);
                        add(self.storage.values, place.diagonal + place.rows * i + j, -compliance);
                        if i != j {
                            add(self.storage.values, place.diagonal + place.rows * j + i, -compliance);
                        }
                    }
                }
            }
            if self.regularisation.share <= T::zero() {
                continue;
            }
            for (k, effect) in effects.iter().enumerate().take(gradients.len()) {
                let mut scale =
                    if port.has_modes() { port.compliance(end.slot + k, end.slot + k) } else { T::zero() };
                for (i, entry) in effect.iter().enumerate() {
                    let mass = get(self.storage.values, diagonal + 7 * i);
                    if mass > T::zero() {
                        scale += *entry * *entry / mass;
                    }
                }
                let shift = scale * self.regularisation.share;
                if side == 0 || place.ends[0].is_none() {
                    set(self.storage.shift, place.unknowns + k, shift);
                } else {
                    add(self.storage.shift, place.unknowns + k, shift);
                }
            }
        }
    }

    /// Accelerations of every body and multipliers, in the factored state.
    ///
    /// With accelerations subtracted (see [`ImplicitTerms`](super::ImplicitTerms)), what is found is their correction.
    pub fn accelerate(&mut self, target: Target<T>) {
        for (index, place) in self.plan.bodies.iter().enumerate() {
            let Some(port) = self.ports.port_mut(index) else { continue };
            for (i, entry) in port.reduced_force().iter().enumerate() {
                set(self.storage.right, place.unknowns + i, *entry);
            }
        }
        for (joint, place) in self.plan.joints.iter().enumerate() {
            let (Some(rows), Some(ends), Some(connection)) =
                (self.storage.rows.get(joint), self.storage.ends.get(joint), self.connections.get(joint))
            else {
                continue;
            };
            let [first, second] = ends;
            for (k, row) in rows.as_slice().iter().enumerate() {
                let mut wanted = match target {
                    Target::Acceleration { gains } => {
                        -row.whole_bias(first, second)
                            - gains[0] * row.velocity(first, second)
                            - gains[1] * row.residual
                    }
                    Target::Velocity { share } => -row.velocity(first, second) / share,
                    Target::Position { share } => -row.residual / share,
                    Target::Aimed => row.residual,
                };
                for (side, end) in place.ends.iter().enumerate() {
                    let Some(end) = end else { continue };
                    let Some(port) = self.ports.port(end.body) else { continue };
                    wanted -= port.modal_acceleration(end.slot + k);
                    if matches!(target, Target::Acceleration { .. }) {
                        let (marker, gradient) = if side == 0 {
                            (connection.first.marker, &row.first)
                        } else {
                            (connection.second.marker, &row.second)
                        };
                        let [linear, angular] = port.subtracted_twist(marker);
                        wanted -= gradient.power(&linear, &angular);
                    }
                }
                set(self.storage.right, place.unknowns + k, wanted);
            }
        }
        self.solve();
    }

    /// Stores what takes the residuals of positions away as they are now, for rows that are evaluated anew before
    /// [`take_aim`](Self::take_aim). `share`: what a change of the unknowns is multiplied by to change places.
    pub fn aim(&mut self, share: T) {
        for (place, rows) in self.plan.joints.iter().zip(self.storage.rows.iter()) {
            for (k, row) in rows.as_slice().iter().enumerate() {
                set(self.storage.right, place.unknowns + k, -row.residual / share);
            }
        }
    }

    /// Puts what [`aim`](Self::aim) has stored in the place of the residuals of rows that were evaluated anew since.
    pub fn take_aim(&mut self) {
        for (place, rows) in self.plan.joints.iter().zip(self.storage.rows.iter_mut()) {
            for (k, row) in rows.as_mut_slice().iter_mut().enumerate() {
                row.residual = get(self.storage.right, place.unknowns + k);
            }
        }
    }

    /// Displacements or changes of velocity of least kinetic energy that take the residuals of a level away, to first order.
    pub fn correct(&mut self, level: Level) {
        self.storage.right.fill(T::zero());
        for index in 0..self.plan.bodies.len() {
            if let Some(port) = self.ports.port_mut(index) {
                port.without_force();
            }
        }
        for (joint, place) in self.plan.joints.iter().enumerate() {
            let (Some(rows), Some(ends)) = (self.storage.rows.get(joint), self.storage.ends.get(joint))
            else {
                continue;
            };
            for (k, row) in rows.as_slice().iter().enumerate() {
                let residual = match level {
                    Level::Position => row.residual,
                    Level::Velocity => row.velocity(&ends[0], &ends[1]),
                };
                set(self.storage.right, place.unknowns + k, -residual);
            }
        }
        self.solve();
    }

    fn solve(&mut self) {
        let Storage { values, solution, right, shift: correction, .. } = &mut *self.storage;
        let (factors, matrix) = halves(values);
        let elimination = &self.plan.elimination;
        copy(solution, right);
        elimination.solve(factors, solution);
        copy(correction, solution);
        for _ in 0..self.regularisation.refinements {
            elimination.subtract_product(matrix, correction, right);
            copy(correction, right);
            elimination.solve(factors, correction);
            for (sum, change) in solution.iter_mut().zip(correction.iter()) {
                *sum += *change;
            }
        }
        for (index, place) in self.plan.bodies.iter().enumerate() {
            let rigid = core::array::from_fn(|i| get(solution, place.unknowns + i));
            if let Some(port) = self.ports.port_mut(index) {
                port.finish(&rigid);
            }
        }
        for place in self.plan.joints {
            for end in place.ends.iter().flatten() {
                let Some(port) = self.ports.port_mut(end.body) else { continue };
                for k in 0..place.rows {
                    port.follow(end.slot + k, -get(solution, place.unknowns + k));
                }
            }
        }
    }

    /// The largest residual of positions and of velocities, and the joint with the largest position residual.
    pub fn residuals(&self) -> ([T; 2], usize) {
        let mut largest = ([T::zero(); 2], 0);
        for (joint, (rows, ends)) in self.storage.rows.iter().zip(self.storage.ends.iter()).enumerate() {
            for row in rows.as_slice() {
                let position = row.residual.abs();
                if is_worse(position, largest.0[0]) {
                    largest.0[0] = position;
                    largest.1 = joint;
                }
                let velocity = row.velocity(&ends[0], &ends[1]).abs();
                if is_worse(velocity, largest.0[1]) {
                    largest.0[1] = velocity;
                }
            }
        }
        largest
    }
}

/// Whether a residual is larger than the largest so far; the first that is not finite is larger than all.
fn is_worse<T: RealField + Copy>(residual: T, largest: T) -> bool {
    residual > largest || (largest.is_finite() && !residual.is_finite())
}

/// The factors and the matrix.
fn halves<T>(values: &mut [T]) -> (&mut [T], &mut [T]) {
    let half = values.len() / 2;
    values.split_at_mut(half)
}

/// Copies as many as both have.
fn copy<T: Copy>(to: &mut [T], from: &[T]) {
    for (place, value) in to.iter_mut().zip(from) {
        *place = *value;
    }
}

fn get<T: RealField + Copy>(numbers: &[T], index: usize) -> T {
    numbers.get(index).copied().unwrap_or(T::zero())
}

fn set<T>(numbers: &mut [T], index: usize, value: T) {
    if let Some(place) = numbers.get_mut(index) {
        *place = value;
    }
}

fn add<T: RealField + Copy>(numbers: &mut [T], index: usize, value: T) {
    if let Some(place) = numbers.get_mut(index) {
        *place += value;
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
