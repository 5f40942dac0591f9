//! The generalised-α method for systems with rotations and constraints.
//!
//! ```text
//! x_new = x ∘ (h v + h² ((½ - β) a + β a_new))
//! v_new = v + h ((1 - γ) a + γ a_new)
//! (1 - α_m) a_new + α_m a = (1 - α_f) v̇_new + α_f v̇,    M v̇_new + Gᵀ λ = f at the end of the step
//! ```
//!
//! with the constraints as the [`Treatment`](crate::mechanism::Treatment) says: positions (index 3), positions and
//! velocities (stabilised index 2), or accelerations, with a projection behind. ∘ is the retraction of the state, the Cayley
//! map where it is a rotation, which leaves the order as it is.
//!
//! Sources: Chung, Hulbert, A time integration algorithm for structural dynamics with improved numerical dissipation: the
//! generalized-α method, J. Appl. Mech. 60 (1993) 371-375 (parameters); Arnold, Brüls, Convergence of the generalized-α
//! scheme for constrained mechanical systems, Multibody Syst. Dyn. 18 (2007) 185-202 (the form with a, constraints, its
//! start); Brüls, Cardona, Arnold, Lie group generalized-α time integration of constrained flexible multibody systems,
//! Mech. Mach. Theory 48 (2012) 121-137; Bottasso, Bauchau, Cardona, Time-step-size-independent conditioning and
//! sensitivity to perturbations in the numerical solution of index three differential algebraic equations, SIAM J. Sci.
//! Comput. 29 (2007) 397-414 (accelerations as unknowns, rows over h²).

use nalgebra::RealField;

use super::system::{begin, displaced, finish, refusal, stage};
use super::{Correction, ImplicitSystem, StepError, StepReport, Tolerances, VectorSpace};

/// The generalised-α method: how much it damps, and when its equations count as solved.
///
/// Order 2 for every `spectral_radius`. Stable for every h ω_max in linear vibration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeneralisedAlpha<T = f64> {
    /// ρ∞ in [0, 1]: what is left per step of a mode with h ω -> ∞. One: no damping; zero: gone at once. Units: 1.
    pub spectral_radius: T,
    /// Most quasi-Newton iterations of a step, each with one evaluation of the loads and one factorisation.
    pub iterations: usize,
    /// The correction of the places that ends the iterations.
    pub tolerances: Tolerances<T>,
}

/// What the method remembers from step to step, at the places of the velocities' rates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AlphaMemory<I> {
    /// v̇: accelerations at the end of the last step.
    pub accelerations: I,
    /// a: the method's own, those of a time α_m - α_f steps later.
    pub shifted: I,
}

/// α_m, α_f, β and γ for a spectral radius.
struct Parameters<T> {
    mass: T,
    force: T,
    beta: T,
    gamma: T,
}

impl<T: RealField + Copy> GeneralisedAlpha<T> {
    /// Moderate damping of what the step does not resolve (ρ∞ = 0.8), at most 20 iterations, places to ten digits, or to
    /// what the number type has.
    pub fn new() -> Self {
        let relative = nalgebra::convert::<f64, T>(1e-10).max(T::default_epsilon() * nalgebra::convert(64.0));
        Self {
            spectral_radius: nalgebra::convert(0.8),
            iterations: 20,
            tolerances: Tolerances { relative, absolute: relative * nalgebra::convert(0.01) },
        }
    }

    fn parameters(&self) -> Parameters<T> {
        let (half, two): (T, T) = (nalgebra::convert(0.5), nalgebra::convert(2.0));
        let radius = self.spectral_radius.max(T::zero()).min(T::one());
        let mass = (two * radius - T::one()) / (radius + T::one());
        let force = radius / (radius + T::one());
        let gamma = half - mass + force;
        let beta = (gamma + half) * (gamma + half) * half * half;
        Parameters { mass, force, beta, gamma }
    }

    /// What the method needs to begin at `state`: its accelerations, and those of a moment later or earlier.
    ///
    /// Two evaluations of the accelerations. Units: `time`, `step` s. Errors: see [`StepError`].
    pub fn start<S: ImplicitSystem<T>>(
        &self,
        system: &S,
        state: &S::State,
        time: T,
        step: T,
    ) -> Result<AlphaMemory<S::Increment>, StepError> {
        let h = begin(system, state, step)?;
        let Parameters { mass, force, .. } = self.parameters();
        let shift = (mass - force) * h;
        let rates = system.rates(time, state, &system.no_change(state))?;
        let mut moved = rates.clone();
        moved.scale(shift);
        let later = system.rates(time + shift, state, &moved)?;
        Ok(AlphaMemory {
            accelerations: system.velocities_only(&rates),
            shifted: system.velocities_only(&later),
        })
    }

    /// One step from `state`; `memory` is that of the last step, or of [`start`](Self::start), and is that of this step then.
    ///
    /// At most [`iterations`](Self::iterations) times one evaluation and one factorisation; no allocation, bounded work.
    /// The error estimate is the difference to a step with constant accelerations.
    ///
    /// Units: `time`, `step` s. Errors: see [`StepError`]; `memory` is then as it was.
    pub fn step<S: ImplicitSystem<T>>(
        &self,
        system: &S,
        memory: &mut AlphaMemory<S::Increment>,
        state: &S::State,
        time: T,
        step: T,
    ) -> Result<(S::State, StepReport<T>), StepError> {
        let h = begin(system, state, step)?;
        let half: T = nalgebra::convert(0.5);
        let Parameters { mass, force, beta, gamma } = self.parameters();
        // d a_new / d v̇_new
        let share = (T::one() - force) / (T::one() - mass);
        let gamma_h = h * (beta * share).sqrt();
        let shifted = |accelerations: &S::Increment| {
            let mut shifted = accelerations.clone();
            shifted.scale(share);
            shifted.add_scaled(force / (T::one() - mass), &memory.accelerations);
            shifted.add_scaled(-mass / (T::one() - mass), &memory.shifted);
            shifted
        };
        let increment = |shifted: &S::Increment, places: &S::Increment| {
            let mut mean = memory.shifted.clone();
            mean.scale((half - beta) * h);
            mean.add_scaled(beta * h, shifted);
            let mut increment = system.place_rates(state, &mean);
            increment.scale(h);
            increment.add_scaled((T::one() - gamma) * h, &memory.shifted);
            increment.add_scaled(gamma * h, shifted);
            increment.add_scaled(T::one(), places);
            increment
        };
        let mut accelerations = memory.accelerations.clone();
        let mut places = system.no_change(state);
        let mut residual = T::zero();
        for iteration in 1..=self.iterations {
            let whole = increment(&shifted(&accelerations), &places);
            let Correction { accelerations: change, places: moved } = stage(
                system,
                time,
                state,
                true,
                system.correction(time + h, state, &whole, &accelerations, gamma_h),
            )?;
            accelerations.add_scaled(T::one(), &change);
            let mut difference = displaced(system, state, &change);
            difference.scale(gamma_h * gamma_h);
            if let Some(moved) = moved {
                places.add_scaled(T::one(), &moved);
                difference.add_scaled(T::one(), &moved);
            }
            residual = system.weighted_error(state, &difference, &self.tolerances);
            if !residual.is_finite() {
                return Err(refusal(system, time + h, state, true));
            }
            if residual <= T::one() {
                let new = shifted(&accelerations);
                let whole = increment(&new, &places);
                let mut jump = new.clone();
                jump.add_scaled(-T::one(), &memory.shifted);
                let mut error = displaced(system, state, &jump);
                error.scale(beta * h * h);
                error.add_scaled(gamma * h, &jump);
                let (state, report) = finish(system, time + h, state, &whole, &error, Some(gamma_h))?;
                *memory = AlphaMemory { accelerations, shifted: new };
                return Ok((state, StepReport { iterations: iteration, ..report }));
            }
        }
        Err(StepError::not_converged(self.iterations, residual))
    }
}

impl<T: RealField + Copy> Default for GeneralisedAlpha<T> {
    fn default() -> Self {
        Self::new()
    }
}
