//! Two free bodies as one system, under a load that sees both.

use nalgebra::RealField;

use super::{FlexibleBody, GeneralisedForce, Increment, Load, State};
use crate::integrators::{
    ImplicitSystem, LocalError, StepError, StiffSystem, System, Tolerances, VectorSpace,
};

/// Something of each of two bodies: the bodies themselves, their states, changes of them, or forces on them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair<A, B = A> {
    /// Of the first body.
    pub first: A,
    /// Of the second body.
    pub second: B,
}

/// Two bodies without joints and what pushes them, from outside or against each other.
#[derive(Debug, Clone, Copy)]
pub struct PairSystem<'a, A, B, L> {
    /// The bodies.
    pub bodies: &'a Pair<A, B>,
    /// What pushes them.
    pub load: &'a L,
}

impl<A: VectorSpace<T>, B: VectorSpace<T>, T: RealField + Copy> VectorSpace<T> for Pair<A, B> {
    fn add_scaled(&mut self, factor: T, other: &Self) {
        self.first.add_scaled(factor, &other.first);
        self.second.add_scaled(factor, &other.second);
    }

    fn scale(&mut self, factor: T) {
        self.first.scale(factor);
        self.second.scale(factor);
    }

    fn dot(&self, other: &Self) -> T {
        self.first.dot(&other.first) + self.second.dot(&other.second)
    }
}

type States<A, B, T> = Pair<State<<A as FlexibleBody<T>>::Modal, T>, State<<B as FlexibleBody<T>>::Modal, T>>;
type Increments<A, B, T> =
    Pair<Increment<<A as FlexibleBody<T>>::Modal, T>, Increment<<B as FlexibleBody<T>>::Modal, T>>;
type Forces<A, B, T> = Pair<
    GeneralisedForce<<A as FlexibleBody<T>>::Modal, T>,
    GeneralisedForce<<B as FlexibleBody<T>>::Modal, T>,
>;

impl<A, B, L> PairSystem<'_, A, B, L> {
    fn forces<T>(&self, time: T, state: &States<A, B, T>) -> Forces<A, B, T>
    where
        A: FlexibleBody<T>,
        B: FlexibleBody<T>,
        L: Load<Pair<A, B>, States<A, B, T>, Forces<A, B, T>, T>,
        T: RealField + Copy,
    {
        let mut forces = Pair {
            first: GeneralisedForce::zeros(&state.first.modal_coordinates),
            second: GeneralisedForce::zeros(&state.second.modal_coordinates),
        };
        self.load.add_to(self.bodies, time, state, &mut forces);
        forces
    }
}

impl<A, B, L, T> System<T> for PairSystem<'_, A, B, L>
where
    A: FlexibleBody<T>,
    B: FlexibleBody<T>,
    L: Load<Pair<A, B>, States<A, B, T>, Forces<A, B, T>, T>,
    T: RealField + Copy,
{
    type State = States<A, B, T>;
    type Increment = Increments<A, B, T>;

    fn is_finite(&self, state: &Self::State) -> bool {
        state.first.is_finite() && state.second.is_finite()
    }

    fn no_change(&self, state: &Self::State) -> Self::Increment {
        Pair {
            first: Increment::zeros(&state.first.modal_coordinates),
            second: Increment::zeros(&state.second.modal_coordinates),
        }
    }

    fn retract(&self, origin: &Self::State, increment: &Self::Increment) -> Self::State {
        Pair {
            first: origin.first.retract(&increment.first),
            second: origin.second.retract(&increment.second),
        }
    }

    fn rates(
        &self,
        time: T,
        origin: &Self::State,
        increment: &Self::Increment,
    ) -> Result<Self::Increment, StepError> {
        let state = self.retract(origin, increment);
        let forces = self.forces(time, &state);
        let Pair { first, second } = self.bodies;
        Ok(Pair {
            first: increment.first.rate_under(first, &state.first, &forces.first),
            second: increment.second.rate_under(second, &state.second, &forces.second),
        })
    }

    fn place_rates(&self, origin: &Self::State, increment: &Self::Increment) -> Self::Increment {
        Pair {
            first: increment.first.place_rate(&origin.first.retract(&increment.first)),
            second: increment.second.place_rate(&origin.second.retract(&increment.second)),
        }
    }

    fn velocities_only(&self, increment: &Self::Increment) -> Self::Increment {
        Pair { first: increment.first.velocities_only(), second: increment.second.velocities_only() }
    }

    fn local_error(&self, difference: &Self::Increment) -> LocalError<T> {
        difference.first.local_error().or(difference.second.local_error())
    }

    fn weighted_error(
        &self,
        state: &Self::State,
        difference: &Self::Increment,
        tolerances: &Tolerances<T>,
    ) -> T {
        let first = difference.first.weighted_squares(&state.first, tolerances);
        let second = difference.second.weighted_squares(&state.second, tolerances);
        ((first.0 + second.0) / (first.1 + second.1)).sqrt()
    }

    fn largest_stable_step(&self) -> Option<T> {
        match (self.bodies.first.largest_stable_step(), self.bodies.second.largest_stable_step()) {
            (Some(first), Some(second)) => Some(first.min(second)),
            (first, second) => first.or(second),
        }
    }
}

impl<A, B, L, T> StiffSystem<T> for PairSystem<'_, A, B, L>
where
    A: FlexibleBody<T>,
    B: FlexibleBody<T>,
    L: Load<Pair<A, B>, States<A, B, T>, Forces<A, B, T>, T>,
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
        let state = self.retract(origin, increment);
        let forces = self.forces(time, &state);
        let Pair { first, second } = self.bodies;
        let (less_first, less_second) =
            (subtracted.map(|pair| &pair.first), subtracted.map(|pair| &pair.second));
        let (first_rate, second_rate) = (
            increment.first.implicit_rate_under(first, &state.first, &forces.first, gamma_h, less_first),
            increment.second.implicit_rate_under(second, &state.second, &forces.second, gamma_h, less_second),
        );
        Ok(Pair {
            first: first_rate.ok_or(StepError::MassNotPositive)?,
            second: second_rate.ok_or(StepError::MassNotPositive)?,
        })
    }
}

impl<A, B, L, T> ImplicitSystem<T> for PairSystem<'_, A, B, L>
where
    A: FlexibleBody<T>,
    B: FlexibleBody<T>,
    L: Load<Pair<A, B>, States<A, B, T>, Forces<A, B, T>, T>,
    T: RealField + Copy,
{
}
