//! An energy-momentum method for systems with rotations, modes and constraints.
//!
//! The equations between beginning and end of a step are those of [`ConservingSystem`]; for a flexible body they stand in
//! `body/span.rs` with their sources. Joints are met at the end of each step (index 3), their reactions do no work over the
//! step, gravity and elastic forces do exactly that of the change of their potentials. What is kept: energy, of mechanisms
//! under gravity and force elements that store energy, with joints that do not depend on time, and momentum of free bodies,
//! both to what the iteration leaves. Springs, torsion springs and bushings have discrete gradients of their own
//! (`ForceElement::wrenches_over`); dampers and other forces act in the means of both ends, to order 2. Of joints, those that
//! hold some rotations and leave others by quaternions (`generic` with one or two rotations) do work of the order h².

use nalgebra::RealField;

use super::system::{ConservingSystem, begin, displaced, finish, refusal, stage};
use super::{StepError, StepReport, Tolerances, VectorSpace};

/// The energy-momentum method: order 2, symmetric in time; when its equations count as solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyMomentum<T = f64> {
    /// Most quasi-Newton iterations of a step, each with one evaluation of the loads and one factorisation.
    pub iterations: usize,
    /// The correction of the places that ends the iterations with one more, down to round-off.
    pub tolerances: Tolerances<T>,
}

impl<T: RealField + Copy> EnergyMomentum<T> {
    /// At most 30 iterations, to round-off.
    pub fn new() -> Self {
        let round_off = T::default_epsilon() * nalgebra::convert(64.0);
        Self {
            iterations: 30,
            tolerances: Tolerances {
                relative: round_off,
                absolute: round_off * nalgebra::convert::<f64, T>(0.1),
            },
        }
    }

    /// One step from `state`.
    ///
    /// At most [`iterations`](Self::iterations) times one evaluation and one factorisation; no allocation, bounded work.
    /// The error estimate is the difference to a step with constant velocities. Units: `time`, `step` s.
    ///
    /// Errors: see [`StepError`]; [`StepError::NotConverged`] with the last correction if the step is too large.
    pub fn step<S: ConservingSystem<T>>(
        &self,
        system: &S,
        state: &S::State,
        time: T,
        step: T,
    ) -> Result<(S::State, StepReport<T>), StepError> {
        let h = begin(system, state, step)?;
        let half = h * nalgebra::convert(0.5);
        let mut velocities = system.no_change(state);
        let mut residual = T::zero();
        let mut last = false;
        for iteration in 1..=self.iterations {
            let corrected = system.conserving_correction(time, state, &velocities, h);
            let corrected = stage(system, time, state, true, corrected)?;
            let change = system.velocities_only(&corrected);
            velocities.add_scaled(T::one(), &change);
            let mut moved = displaced(system, state, &change);
            moved.scale(half);
            residual = system.weighted_error(state, &moved, &self.tolerances);
            if !residual.is_finite() {
                return Err(refusal(system, time + h, state, true));
            }
            let small = residual <= T::one();
            // one more correction takes what is left down to round-off: errors of energy do not add up then
            if small && !last {
                last = true;
                continue;
            }
            if small {
                let mut whole = system.conserving_places(state, &velocities, h);
                let mut error = whole.clone();
                error.add_scaled(-h, &system.place_rates(state, &system.no_change(state)));
                whole.add_scaled(T::one(), &velocities);
                let (state, report) = finish(system, time + h, state, &whole, &error, Some(half))?;
                return Ok((state, StepReport { iterations: iteration, ..report }));
            }
        }
        Err(StepError::not_converged(self.iterations, residual))
    }
}

impl<T: RealField + Copy> Default for EnergyMomentum<T> {
    fn default() -> Self {
        Self::new()
    }
}
