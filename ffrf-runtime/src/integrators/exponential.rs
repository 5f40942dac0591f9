//! An exponential step for bodies whose stiff modes no joint holds.
//!
//! With y' = L y + N(y), where L holds each mode on its own, q̈ = -d q̇ - ω² q, and nothing else, a step is
//!
//! ```text
//! a = e^{h L} y + h φ_1(h L) N(y),    y_new = a + h φ_2(h L) (N(a) - N(y))
//! ```
//!
//! so that free vibration is exact, with its amplitude, for any h ω. What couples modes to rigid motion is in N: it must not
//! be stiff. That is so for free-free modes, which have no momentum of their own, and not where joints hold what stiff
//! modes move: such systems refuse the step.
//!
//! Source: Cox, Matthews, Exponential time differencing for stiff systems, J. Comp. Phys. 176 (2002) 430-455, ETD2RK.

use nalgebra::RealField;

use super::step::checked_step_size;
use super::system::{begin, finish, stage};
use super::{StepError, StepReport, System, VectorSpace};

/// Which answer of the modes is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Forcing {
    /// To accelerations that stay.
    Constant,
    /// To accelerations that grow from zero to the given ones.
    Ramp,
}

/// A system whose modes vibrate each on its own, but for what is not stiff.
pub trait ExponentialSystem<T: RealField + Copy>: System<T> {
    /// The answers of all modes within one step size.
    type Modes;

    /// The answers within `step` (s).
    ///
    /// Errors: [`StepError::ModesNotSeparate`].
    fn modes(&self, step: T) -> Result<Self::Modes, StepError>;
    /// L y: the rates of free vibration of each mode in `state`; zero elsewhere.
    fn vibration_rates(&self, modes: &Self::Modes, state: &Self::State) -> Self::Increment;
    /// (e^{h L} - 1) y: the change in free vibration from `state`; zero elsewhere.
    fn free_vibration(&self, modes: &Self::Modes, state: &Self::State) -> Self::Increment;
    /// h φ_1(h L) `rates`, or h φ_2(h L) `rates`.
    fn forced_vibration(
        &self,
        modes: &Self::Modes,
        rates: &Self::Increment,
        forcing: Forcing,
    ) -> Self::Increment;
}

/// The exponential step of one size: what the modes answer within it is computed once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponential<M, T = f64> {
    modes: M,
    step: T,
}

impl<M, T: RealField + Copy> Exponential<M, T> {
    /// For steps of this size. Units: s.
    ///
    /// Errors: [`StepError::StepSize`]; [`StepError::ModesNotSeparate`] where joints hold what modes move, or where modal mass,
    /// stiffness or damping are not diagonal.
    pub fn new<S: ExponentialSystem<T, Modes = M>>(system: &S, step: T) -> Result<Self, StepError> {
        let step = checked_step_size(step)?;
        Ok(Self { modes: system.modes(step)?, step })
    }

    /// One step, order 2: free vibration is exact for any h ω.
    ///
    /// Two evaluations of the accelerations; no allocation, bounded work. The error estimate is the difference to the method
    /// of order one, a. Source: see the module's text, Cox and Matthews (2002).
    ///
    /// Units: `time` s. Errors: see [`StepError`].
    pub fn step<S: ExponentialSystem<T, Modes = M>>(
        &self,
        system: &S,
        state: &S::State,
        time: T,
    ) -> Result<(S::State, StepReport<T>), StepError> {
        let h = begin(system, state, self.step)?;
        let modes = &self.modes;
        let mut first = system.rates(time, state, &system.no_change(state))?;
        first.add_scaled(-T::one(), &system.vibration_rates(modes, state));
        let mut whole = system.free_vibration(modes, state);
        whole.add_scaled(T::one(), &system.forced_vibration(modes, &first, Forcing::Constant));

        let mut change = stage(system, time, state, false, system.rates(time + h, state, &whole))?;
        change.add_scaled(-T::one(), &system.vibration_rates(modes, &system.retract(state, &whole)));
        change.add_scaled(-T::one(), &first);
        let error = system.forced_vibration(modes, &change, Forcing::Ramp);
        whole.add_scaled(T::one(), &error);
        finish(system, time + h, state, &whole, &error, None)
    }
}

/// One [`Exponential`] step, with the answers of the modes made for it; where steps are equal, keep those.
///
/// Units: `time`, `step` s. Errors: see [`Exponential::new`] and [`Exponential::step`].
pub fn step_exponential<S: ExponentialSystem<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    step: T,
) -> Result<(S::State, StepReport<T>), StepError> {
    Exponential::new(system, step)?.step(system, state, time)
}
