//! A free body under a load, as a system that integrators advance.

use nalgebra::{RealField, Vector3};

use super::{FlexibleBody, GeneralisedForce, Increment, Load, ModalVector, Oscillators, Span, State};
use crate::integrators::{
    ConservingSystem, ExponentialSystem, Forcing, ImplicitSystem, LocalError, StepError, StiffSystem, System,
    Tolerances, VectorSpace, too_large,
};

/// A body without joints and what pushes it.
#[derive(Debug, Clone, Copy)]
pub struct FreeSystem<'a, B, L> {
    /// The body.
    pub body: &'a B,
    /// What pushes it.
    pub load: &'a L,
}

impl<V: ModalVector<T>, T: RealField + Copy> VectorSpace<T> for Increment<V, T> {
    fn add_scaled(&mut self, factor: T, other: &Self) {
        self.add_scaled(factor, other);
    }

    fn scale(&mut self, factor: T) {
        self.scale(factor);
    }

    fn dot(&self, other: &Self) -> T {
        self.dot(other)
    }
}

impl<B, L> FreeSystem<'_, B, L> {
    fn force<T>(&self, time: T, state: &State<B::Modal, T>) -> GeneralisedForce<B::Modal, T>
    where
        B: FlexibleBody<T>,
        L: Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T>,
        T: RealField + Copy,
    {
        let mut force = GeneralisedForce::zeros(&state.modal_coordinates);
        self.load.add_to(self.body, time, state, &mut force);
        force
    }
}

impl<B, L, T> System<T> for FreeSystem<'_, B, L>
where
    B: FlexibleBody<T>,
    L: Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T>,
    T: RealField + Copy,
{
    type State = State<B::Modal, T>;
    type Increment = Increment<B::Modal, T>;

    fn is_finite(&self, state: &Self::State) -> bool {
        state.is_finite()
    }

    fn no_change(&self, state: &Self::State) -> Self::Increment {
        Increment::zeros(&state.modal_coordinates)
    }

    fn retract(&self, origin: &Self::State, increment: &Self::Increment) -> Self::State {
        origin.retract(increment)
    }

    fn rates(
        &self,
        time: T,
        origin: &Self::State,
        increment: &Self::Increment,
    ) -> Result<Self::Increment, StepError> {
        let state = origin.retract(increment);
        Ok(increment.rate_under(self.body, &state, &self.force(time, &state)))
    }

    fn place_rates(&self, origin: &Self::State, increment: &Self::Increment) -> Self::Increment {
        increment.place_rate(&origin.retract(increment))
    }

    fn velocities_only(&self, increment: &Self::Increment) -> Self::Increment {
        increment.velocities_only()
    }

    fn local_error(&self, difference: &Self::Increment) -> LocalError<T> {
        difference.local_error()
    }

    fn weighted_error(
        &self,
        state: &Self::State,
        difference: &Self::Increment,
        tolerances: &Tolerances<T>,
    ) -> T {
        let (sum, count) = difference.weighted_squares(state, tolerances);
        (sum / count).sqrt()
    }

    fn largest_stable_step(&self) -> Option<T> {
        self.body.largest_stable_step()
    }

    fn refusal(&self, time: T, state: &Self::State) -> StepError {
        // kernels say of a mass matrix that is not positive definite that accelerations are not a number
        let rest = self.body.undeformed();
        let undeformed = self.body.prepare(&rest, &Vector3::zeros(), &rest);
        let modes = self.body.modal_mass().factor();
        if modes.and_then(|modes| undeformed.eliminate(modes).factor()).is_none() {
            return StepError::MassNotPositive;
        }
        if self.force(time, state).is_finite() {
            too_large(self.largest_stable_step())
        } else {
            StepError::NonFiniteAcceleration
        }
    }
}

impl<B, L, T> StiffSystem<T> for FreeSystem<'_, B, L>
where
    B: FlexibleBody<T>,
    L: Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T>,
    T: RealField + Copy,
{
    fn implicit_rates(
        &self,
        time: T,
        origin: &Self::State,
        increment: &Self::Increment,
        gamma_h: T,
        subtracted: Option<&Self::Increment>,
    ) -> Result<Self::Increment, StepError> {
        let state = origin.retract(increment);
        increment
            .implicit_rate_under(self.body, &state, &self.force(time, &state), gamma_h, subtracted)
            .ok_or(StepError::MassNotPositive)
    }
}

impl<B, L, T> ImplicitSystem<T> for FreeSystem<'_, B, L>
where
    B: FlexibleBody<T>,
    L: Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T>,
    T: RealField + Copy,
{
}

impl<B, L, T> ConservingSystem<T> for FreeSystem<'_, B, L>
where
    B: FlexibleBody<T>,
    L: Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T>,
    T: RealField + Copy,
{
    fn conserving_places(
        &self,
        begin: &Self::State,
        velocities: &Self::Increment,
        step: T,
    ) -> Self::Increment {
        Span::new(begin, velocities, step).increment.places_only()
    }

    fn conserving_correction(
        &self,
        time: T,
        begin: &Self::State,
        velocities: &Self::Increment,
        step: T,
    ) -> Result<Self::Increment, StepError> {
        let span = Span::new(begin, velocities, step);
        let force = self.force(time + step * nalgebra::convert(0.5), &span.middle);
        let (stage, missing) =
            span.stage(self.body, &span.dual_to_mean(force)).ok_or(StepError::MassNotPositive)?;
        let factors = stage.eliminated.factor().ok_or(StepError::MassNotPositive)?;
        Ok(span.with_correction(&factors.solve(&missing)))
    }
}

impl<B, L, T> ExponentialSystem<T> for FreeSystem<'_, B, L>
where
    B: FlexibleBody<T>,
    L: Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T>,
    T: RealField + Copy,
{
    type Modes = Oscillators<B::Modal, T>;

    fn modes(&self, step: T) -> Result<Self::Modes, StepError> {
        Oscillators::new(self.body, step).ok_or(StepError::ModesNotSeparate)
    }

    fn vibration_rates(&self, modes: &Self::Modes, state: &Self::State) -> Self::Increment {
        modes.rates(state)
    }

    fn free_vibration(&self, modes: &Self::Modes, state: &Self::State) -> Self::Increment {
        modes.free(state)
    }

    fn forced_vibration(
        &self,
        modes: &Self::Modes,
        rates: &Self::Increment,
        forcing: Forcing,
    ) -> Self::Increment {
        modes.forced(rates, forcing)
    }
}
