//! A free body under a load, as a system that integrators advance.

use nalgebra::RealField;

use super::{FlexibleBody, GeneralisedForce, Increment, ModalVector, Motion, State};
use crate::forces::Load;
use crate::integrators::{LocalError, StepError, StiffSystem, System, Tolerances, VectorSpace};

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
        let mut force = GeneralisedForce::zeros(&state.modal_coordinates);
        self.load.add_to(self.body, time, &state, &mut force);
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &state;
        let accelerations =
            self.body.forward_dynamics(modal_coordinates, angular_velocity, modal_rates, &force);
        Ok(increment.rate(&state, accelerations))
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
        let stage = ImplicitBody::new(self.body, &state, gamma_h)?;
        let mut force = GeneralisedForce::zeros(&state.modal_coordinates);
        self.load.add_to(self.body, time, &state, &mut force);
        let right = stage.right(self.body, &state, &force, subtracted);
        let accelerations = stage.factors.solve(&stage.prepared, &right);
        Ok(stage.rate(&state, increment, accelerations, subtracted))
    }
}

/// One body in a stage of a linearly implicit step.
pub(crate) struct ImplicitBody<V: ModalVector<T>, T: RealField + Copy> {
    pub(crate) prepared: super::Prepared<V, T>,
    /// Of M(q) with γ h D_ff + γ² h² K_ff added to Θ_ff.
    pub(crate) factors: super::Eliminated<V, T>,
    gamma_h: T,
}

impl<V: ModalVector<T>, T: RealField + Copy> ImplicitBody<V, T> {
    pub(crate) fn new<B: FlexibleBody<T, Modal = V>>(
        body: &B,
        state: &State<V, T>,
        gamma_h: T,
    ) -> Result<Self, StepError> {
        let prepared = body.prepare(&state.modal_coordinates, &state.angular_velocity, &state.modal_rates);
        let modal =
            body.modal_mass().plus(gamma_h, &body.damping()).plus(gamma_h * gamma_h, &body.stiffness());
        let factors =
            modal.factor().and_then(|modal| prepared.eliminate(modal)).ok_or(StepError::MassNotPositive)?;
        Ok(Self { prepared, factors, gamma_h })
    }

    /// M(q) r - γ h [0; 0; K_ff r_q], where r = accelerations under `force` less what is subtracted.
    pub(crate) fn right<B: FlexibleBody<T, Modal = V>>(
        &self,
        body: &B,
        state: &State<V, T>,
        force: &GeneralisedForce<V, T>,
        subtracted: Option<&Increment<V, T>>,
    ) -> GeneralisedForce<V, T> {
        let mut right = self.prepared.net_force(force);
        let mut moved = state.modal_rates.clone();
        if let Some(subtracted) = subtracted {
            let motion = Motion {
                linear: state.to_body(&subtracted.velocity),
                angular: subtracted.angular_velocity,
                modal: subtracted.modal_rates.clone(),
            };
            right.add_scaled(-T::one(), &self.prepared.mass_times(&body.modal_mass(), &motion));
            moved.add_scaled(-T::one(), &subtracted.modal_coordinates);
        }
        right.modal.add_scaled(-self.gamma_h, &body.stiffness().product(&moved));
        right
    }

    /// The stage k of the solution of its linear system.
    pub(crate) fn rate(
        &self,
        state: &State<V, T>,
        increment: &Increment<V, T>,
        accelerations: Motion<V, T>,
        subtracted: Option<&Increment<V, T>>,
    ) -> Increment<V, T> {
        let modal_rates = accelerations.modal.clone();
        let mut rate = increment.rate(state, accelerations);
        rate.modal_coordinates.add_scaled(self.gamma_h, &modal_rates);
        if let Some(subtracted) = subtracted {
            rate.position -= subtracted.position;
            rate.rotation -= subtracted.rotation;
            rate.modal_coordinates.add_scaled(-T::one(), &subtracted.modal_coordinates);
        }
        rate
    }
}
