//! A system that says in the report of each step whether its state has left what was planned.

use nalgebra::RealField;

use super::Departure;
use super::exponential::{ExponentialSystem, Forcing};
use super::step::{Drift, LocalError, StepError, Tolerances};
use super::system::{ConservingSystem, Correction, ImplicitSystem, StiffSystem, System};

/// A system and what looks at the state at the end of each step; everything else is the system's own, bit by bit.
///
/// ```
/// # use ffrf_runtime::{Departure, Watched};
/// # fn example<S>(system: &S) {
/// // the envelope of one body of a mechanism: |state: &SliderCrankState| envelope.departure(&state.rod)
/// let watched = Watched { system, look: |_state: &[f64; 2]| Departure::default() };
/// # let _ = watched;
/// # }
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Watched<'a, S, L> {
    /// The system.
    pub system: &'a S,
    /// What a state has left, see [`Envelope::departure`](crate::Envelope::departure).
    pub look: L,
}

impl<T: RealField + Copy, S: System<T>, L: Fn(&S::State) -> Departure> System<T> for Watched<'_, S, L> {
    type State = S::State;
    type Increment = S::Increment;

    fn departure(&self, state: &S::State) -> Departure {
        self.system.departure(state).or((self.look)(state))
    }

    fn is_finite(&self, state: &S::State) -> bool {
        self.system.is_finite(state)
    }

    fn no_change(&self, state: &S::State) -> S::Increment {
        self.system.no_change(state)
    }

    fn retract(&self, origin: &S::State, increment: &S::Increment) -> S::State {
        self.system.retract(origin, increment)
    }

    fn rates(&self, time: T, origin: &S::State, increment: &S::Increment) -> Result<S::Increment, StepError> {
        self.system.rates(time, origin, increment)
    }

    fn place_rates(&self, origin: &S::State, increment: &S::Increment) -> S::Increment {
        self.system.place_rates(origin, increment)
    }

    fn velocities_only(&self, increment: &S::Increment) -> S::Increment {
        self.system.velocities_only(increment)
    }

    fn local_error(&self, difference: &S::Increment) -> LocalError<T> {
        self.system.local_error(difference)
    }

    fn weighted_error(&self, state: &S::State, difference: &S::Increment, tolerances: &Tolerances<T>) -> T {
        self.system.weighted_error(state, difference, tolerances)
    }

    fn settle(
        &self,
        time: T,
        state: S::State,
        gamma_h: Option<T>,
    ) -> Result<(S::State, Drift<T>), StepError> {
        self.system.settle(time, state, gamma_h)
    }

    fn largest_stable_step(&self) -> Option<T> {
        self.system.largest_stable_step()
    }

    fn refusal(&self, time: T, state: &S::State) -> StepError {
        self.system.refusal(time, state)
    }
}

impl<T: RealField + Copy, S: StiffSystem<T>, L: Fn(&S::State) -> Departure> StiffSystem<T>
    for Watched<'_, S, L>
{
    fn implicit_rates(
        &self,
        time: T,
        origin: &S::State,
        increment: &S::Increment,
        gamma_h: T,
        subtracted: Option<&S::Increment>,
    ) -> Result<S::Increment, StepError> {
        self.system.implicit_rates(time, origin, increment, gamma_h, subtracted)
    }
}

impl<T: RealField + Copy, S: ImplicitSystem<T>, L: Fn(&S::State) -> Departure> ImplicitSystem<T>
    for Watched<'_, S, L>
{
    fn correction(
        &self,
        time: T,
        origin: &S::State,
        increment: &S::Increment,
        accelerations: &S::Increment,
        gamma_h: T,
    ) -> Result<Correction<S::Increment>, StepError> {
        self.system.correction(time, origin, increment, accelerations, gamma_h)
    }
}

impl<T: RealField + Copy, S: ConservingSystem<T>, L: Fn(&S::State) -> Departure> ConservingSystem<T>
    for Watched<'_, S, L>
{
    fn conserving_places(&self, begin: &S::State, velocities: &S::Increment, step: T) -> S::Increment {
        self.system.conserving_places(begin, velocities, step)
    }

    fn conserving_correction(
        &self,
        time: T,
        begin: &S::State,
        velocities: &S::Increment,
        step: T,
    ) -> Result<S::Increment, StepError> {
        self.system.conserving_correction(time, begin, velocities, step)
    }
}

impl<T: RealField + Copy, S: ExponentialSystem<T>, L: Fn(&S::State) -> Departure> ExponentialSystem<T>
    for Watched<'_, S, L>
{
    type Modes = S::Modes;

    fn modes(&self, step: T) -> Result<S::Modes, StepError> {
        self.system.modes(step)
    }

    fn vibration_rates(&self, modes: &S::Modes, state: &S::State) -> S::Increment {
        self.system.vibration_rates(modes, state)
    }

    fn free_vibration(&self, modes: &S::Modes, state: &S::State) -> S::Increment {
        self.system.free_vibration(modes, state)
    }

    fn forced_vibration(&self, modes: &S::Modes, rates: &S::Increment, forcing: Forcing) -> S::Increment {
        self.system.forced_vibration(modes, rates, forcing)
    }
}
