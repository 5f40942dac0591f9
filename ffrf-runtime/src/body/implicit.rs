//! One body in a stage of a linearly implicit step.

use nalgebra::RealField;

use super::{
    Eliminated, FlexibleBody, GeneralisedForce, Increment, ModalMatrix, ModalVector, Motion, Prepared, State,
};
use crate::rotation::{cayley_omega, cayley_rate};

/// The deformed quantities of a stage, with γ h D_ff + γ² h² K_ff added to Θ_ff.
#[derive(Debug, Clone)]
pub(crate) struct ImplicitBody<V: ModalVector<T>, T: RealField + Copy> {
    pub(crate) prepared: Prepared<V, T>,
    pub(crate) eliminated: Eliminated<V, T>,
    gamma_h: T,
}

/// Θ_ff + γ h D_ff + γ² h² K_ff. Shape: M x M.
pub(crate) fn implicit_modal_mass<B: FlexibleBody<T>, T: RealField + Copy>(
    body: &B,
    gamma_h: T,
) -> ModalMatrix<B::Modal, T> {
    body.modal_mass().plus(gamma_h, &body.damping()).plus(gamma_h * gamma_h, &body.stiffness())
}

impl<V: ModalVector<T>, T: RealField + Copy> ImplicitBody<V, T> {
    /// `None` if the modal mass with the implicit terms is not positive definite.
    // inlined, so that it is made where it stays
    #[inline(always)]
    pub(crate) fn new<B>(body: &B, state: &State<V, T>, gamma_h: T) -> Option<Self>
    where
        B: FlexibleBody<T, Modal = V>,
    {
        let prepared = body.prepare(&state.modal_coordinates, &state.angular_velocity, &state.modal_rates);
        let eliminated = prepared.eliminate(implicit_modal_mass(body, gamma_h).factor()?);
        Some(Self { prepared, eliminated, gamma_h })
    }

    /// M(q) r - γ h [0; 0; K_ff r_q], where r is the accelerations under `force` less what is subtracted.
    pub(crate) fn right<B>(
        &self,
        body: &B,
        state: &State<V, T>,
        force: &GeneralisedForce<V, T>,
        subtracted: Option<&Increment<V, T>>,
    ) -> GeneralisedForce<V, T>
    where
        B: FlexibleBody<T, Modal = V>,
    {
        implicit_right(&self.prepared, body, state, force, self.gamma_h, subtracted)
    }
}

/// See [`ImplicitBody::right`].
pub(crate) fn implicit_right<B: FlexibleBody<T>, T: RealField + Copy>(
    prepared: &Prepared<B::Modal, T>,
    body: &B,
    state: &State<B::Modal, T>,
    force: &GeneralisedForce<B::Modal, T>,
    gamma_h: T,
    subtracted: Option<&Increment<B::Modal, T>>,
) -> GeneralisedForce<B::Modal, T> {
    let mut right = prepared.net_force(force);
    let mut moved = state.modal_rates.clone();
    if let Some(subtracted) = subtracted {
        let motion = subtracted.velocities(state);
        right.add_scaled(-T::one(), &prepared.mass_times(&body.modal_mass(), &motion));
        moved.add_scaled(-T::one(), &subtracted.modal_coordinates);
    }
    right.modal.add_scaled(-gamma_h, &body.stiffness().product(&moved));
    right
}

impl<V: ModalVector<T>, T: RealField + Copy> Increment<V, T> {
    /// The parts of the velocities, resolved in the body frame of `state`.
    pub(crate) fn velocities(&self, state: &State<V, T>) -> Motion<V, T> {
        Motion {
            linear: state.to_body(&self.velocity),
            angular: self.angular_velocity,
            modal: self.modal_rates.clone(),
        }
    }

    /// [`rate`](Self::rate) of a linearly implicit stage: the modal coordinates see the end of it, less what is subtracted.
    pub fn implicit_rate(
        &self,
        state: &State<V, T>,
        accelerations: Motion<V, T>,
        gamma_h: T,
        subtracted: Option<&Self>,
    ) -> Self {
        let mut rate = self.rate(state, accelerations);
        rate.look_ahead(gamma_h, subtracted);
        rate
    }

    /// Lets rates of the modal coordinates see the end of a linearly implicit stage, and takes from those of all places what is
    /// subtracted.
    pub(crate) fn look_ahead(&mut self, gamma_h: T, subtracted: Option<&Self>) {
        self.modal_coordinates.add_scaled(gamma_h, &self.modal_rates);
        if let Some(subtracted) = subtracted {
            self.position -= subtracted.position;
            self.rotation -= subtracted.rotation;
            self.modal_coordinates.add_scaled(-T::one(), &subtracted.modal_coordinates);
        }
    }

    /// Lets the rates of frames' places see the end of a linearly implicit stage, as those of modes do: for soft rows, which
    /// draw frames back. `rate`: what [`implicit_rate`](Self::implicit_rate) has given.
    pub(crate) fn follow_end(&self, rate: &mut Self, gamma_h: T) {
        rate.position += rate.velocity * gamma_h;
        rate.rotation += cayley_rate(&self.rotation, &rate.angular_velocity) * gamma_h;
    }

    /// The parts of the places as a twist, in the body frame of `state`, in the chart at `at`, which has led to it.
    pub(crate) fn displacements(&self, at: &Self, state: &State<V, T>) -> Motion<V, T> {
        Motion {
            linear: state.to_body(&self.position),
            angular: cayley_omega(&at.rotation, &self.rotation),
            modal: self.modal_coordinates.clone(),
        }
    }

    /// [`implicit_rate`](Self::implicit_rate) of a free body under `force`; `None` if its mass is not positive definite.
    pub(crate) fn implicit_rate_under<B: FlexibleBody<T, Modal = V>>(
        &self,
        body: &B,
        state: &State<V, T>,
        force: &GeneralisedForce<V, T>,
        gamma_h: T,
        subtracted: Option<&Self>,
    ) -> Option<Self> {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = state;
        let prepared = body.prepare(modal_coordinates, angular_velocity, modal_rates);
        let right = implicit_right(&prepared, body, state, force, gamma_h, subtracted);
        let accelerations = prepared.eliminate(implicit_modal_mass(body, gamma_h).factor()?).solve(&right)?;
        Some(self.implicit_rate(state, accelerations, gamma_h, subtracted))
    }
}
