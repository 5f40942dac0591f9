//! The workspace of one body in a mechanism.

use nalgebra::{RealField, Vector3, Vector6};

use super::{Phase, Port};
use crate::body::{
    Eliminated, FlexibleBody, GeneralisedForce, ImplicitBody, Increment, Marker, MarkerMotion, MarkerStep,
    ModalVector, Motion, PlacedMarker, Span, SpanMarker, State, Wrench,
};
use crate::integrators::StepError;

/// A constraint row on one body: its gradient to the modes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AttachedRow<V> {
    /// Modal part of the gradient. Shape: M.
    modal: V,
    /// Θ_ff⁻¹ times that. Shape: M.
    weighted: V,
}

impl<V: Clone> AttachedRow<V> {
    /// A row without effect.
    pub fn empty(zeros: &V) -> Self {
        Self { modal: zeros.clone(), weighted: zeros.clone() }
    }
}

/// What a linearly implicit stage adds to an evaluation.
#[derive(Debug)]
pub struct ImplicitTerms<'a, I, T> {
    /// γ h. Units: s.
    pub gamma_h: T,
    /// What is subtracted from the rates.
    pub subtracted: Option<&'a I>,
}

impl<I, T: Copy> Clone for ImplicitTerms<'_, I, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<I, T: Copy> Copy for ImplicitTerms<'_, I, T> {}

/// One body in one state, with its forces and the rows of its joints; `R` holds as many rows as joints have there.
#[derive(Debug, Clone)]
pub struct BodyPort<'a, B: FlexibleBody<T>, R, T: RealField + Copy> {
    body: &'a B,
    markers: &'a [Marker<B::Modal, T>],
    /// The state of this evaluation.
    pub state: State<B::Modal, T>,
    /// Force of loads and force elements so far.
    pub force: GeneralisedForce<B::Modal, T>,
    /// The result: accelerations, or a correction of place or velocities.
    pub motion: Motion<B::Modal, T>,
    implicit: Option<ImplicitTerms<'a, Increment<B::Modal, T>, T>>,
    rows: R,
    eliminated: Option<Eliminated<B::Modal, T>>,
    net: GeneralisedForce<B::Modal, T>,
    alone: B::Modal,
    /// A step of the energy-momentum method, and what is shown of it.
    span: Option<(Span<B::Modal, T>, Phase)>,
}

impl<'a, B, R, T> BodyPort<'a, B, R, T>
where
    B: FlexibleBody<T>,
    R: AsRef<[AttachedRow<B::Modal>]> + AsMut<[AttachedRow<B::Modal>]>,
    T: RealField + Copy,
{
    /// A body in a state, without forces.
    pub fn new(
        body: &'a B,
        markers: &'a [Marker<B::Modal, T>],
        state: State<B::Modal, T>,
        rows: R,
        implicit: Option<ImplicitTerms<'a, Increment<B::Modal, T>, T>>,
    ) -> Self {
        let zeros = body.undeformed();
        Self {
            body,
            markers,
            state,
            force: GeneralisedForce::zeros(&zeros),
            motion: Motion::zeros(&zeros),
            implicit,
            rows,
            eliminated: None,
            net: GeneralisedForce::zeros(&zeros),
            alone: zeros,
            span: None,
        }
    }

    /// The rate of `increment`, which has led to this state, from the resulting accelerations.
    ///
    /// In a step of the energy-momentum method: the change of the places over the step, and the correction of velocities.
    pub fn rate(&self, increment: &Increment<B::Modal, T>) -> Increment<B::Modal, T> {
        let accelerations = self.motion.clone();
        if let Some((span, _)) = &self.span {
            return span.with_correction(&accelerations);
        }
        match self.implicit {
            None => increment.rate(&self.state, accelerations),
            Some(ImplicitTerms { gamma_h, subtracted }) => {
                increment.implicit_rate(&self.state, accelerations, gamma_h, subtracted)
            }
        }
    }

    /// Place and motion of any marker of this body, one that no joint uses among them.
    pub fn motion_of(&self, marker: &Marker<B::Modal, T>) -> MarkerMotion<T> {
        match &self.span {
            Some((span, Phase::End)) => PlacedMarker::new(marker, &span.end).motion(&span.end),
            Some((span, Phase::Mean)) => SpanMarker::new(marker, span).motion(),
            None => PlacedMarker::new(marker, &self.state).motion(&self.state),
        }
    }

    /// Adds a wrench (inertial) at any marker of this body to the force on it.
    pub fn push_at(&mut self, marker: &Marker<B::Modal, T>, wrench: &Wrench<T>) {
        let force = self.force_of(marker, wrench);
        self.force.add_scaled(T::one(), &force);
    }

    fn force_of(&self, marker: &Marker<B::Modal, T>, wrench: &Wrench<T>) -> GeneralisedForce<B::Modal, T> {
        match &self.span {
            Some((span, _)) => SpanMarker::new(marker, span).generalised_force(wrench),
            None => PlacedMarker::new(marker, &self.state).generalised_force(wrench),
        }
    }

    fn placed(&self, marker: usize) -> Option<PlacedMarker<'a, B::Modal, T>> {
        self.markers.get(marker).map(|marker| PlacedMarker::new(marker, &self.state))
    }

    fn generalised_force(&self, marker: usize, wrench: &Wrench<T>) -> Option<GeneralisedForce<B::Modal, T>> {
        self.markers.get(marker).map(|marker| self.force_of(marker, wrench))
    }

    fn twist(&self, marker: usize, motion: &Motion<B::Modal, T>) -> [Vector3<T>; 2] {
        self.placed(marker).map_or([Vector3::zeros(); 2], |placed| placed.twist(motion))
    }
}

impl<B, R, T> Port<T> for BodyPort<'_, B, R, T>
where
    B: FlexibleBody<T>,
    R: AsRef<[AttachedRow<B::Modal>]> + AsMut<[AttachedRow<B::Modal>]>,
    T: RealField + Copy,
{
    fn marker_motion(&self, marker: usize) -> MarkerMotion<T> {
        match self.markers.get(marker) {
            Some(marker) => self.motion_of(marker),
            None => MarkerMotion::fixed(self.state.position, self.state.orientation),
        }
    }

    fn marker_step(&self, marker: usize) -> Option<MarkerStep<T>> {
        let ((span, _), marker) = (self.span.as_ref()?, self.markers.get(marker)?);
        let ends = [&span.begin, &span.end].map(|state| PlacedMarker::new(marker, state).motion(state));
        Some(MarkerStep { ends, mean: SpanMarker::new(marker, span).motion(), step: span.step })
    }

    fn push(&mut self, marker: usize, wrench: &Wrench<T>) {
        if let Some(force) = self.generalised_force(marker, wrench) {
            self.force.add_scaled(T::one(), &force);
        }
    }

    fn weigh(&mut self, gravity: &Vector3<T>) {
        if let Some((span, _)) = &self.span {
            self.force.add_scaled(T::one(), &span.weight(self.body, gravity));
            return;
        }
        let resolved = self.state.to_body(gravity);
        let weight = self.body.gravity_force(&self.state.modal_coordinates, &resolved);
        self.force.add_scaled(T::one(), &weight);
    }

    fn conserve(&mut self, phase: Phase) {
        match (&mut self.span, self.implicit) {
            (Some((_, shown)), _) => *shown = phase,
            (place, Some(ImplicitTerms { gamma_h, subtracted: Some(velocities) })) => {
                let span = Span::new(&self.state, velocities, gamma_h + gamma_h);
                self.state = span.middle.clone();
                *place = Some((span, phase));
            }
            _ => {}
        }
    }

    fn factor(&mut self) -> Result<(), StepError> {
        if let Some((span, _)) = &self.span {
            let (stage, missing) = span.stage(self.body, &self.force).ok_or(StepError::MassNotPositive)?;
            self.net = missing;
            self.eliminated = Some(stage.eliminated);
            return Ok(());
        }
        let (body, state) = (self.body, &self.state);
        let eliminated = match self.implicit {
            None => {
                let prepared =
                    body.prepare(&state.modal_coordinates, &state.angular_velocity, &state.modal_rates);
                self.net = prepared.net_force(&self.force);
                body.modal_mass().factor().map(|modal| prepared.eliminate(modal))
            }
            Some(ImplicitTerms { gamma_h, subtracted }) => {
                ImplicitBody::new(body, state, gamma_h).map(|stage| {
                    self.net = stage.right(body, state, &self.force, subtracted);
                    stage.eliminated
                })
            }
        };
        self.eliminated = eliminated;
        if self.eliminated.is_some() { Ok(()) } else { Err(StepError::MassNotPositive) }
    }

    fn rigid_mass(&self) -> [[T; 6]; 6] {
        self.eliminated.as_ref().map_or([[T::zero(); 6]; 6], |eliminated| eliminated.remaining.into())
    }

    fn has_modes(&self) -> bool {
        !self.alone.as_slice().is_empty()
    }

    fn attach(&mut self, slot: usize, marker: usize, gradients: &[Wrench<T>], effects: &mut [[T; 6]]) {
        let (Some(marker), Some(eliminated)) = (self.markers.get(marker), &self.eliminated) else { return };
        let placed = PlacedMarker::new(marker, &self.state);
        let spanned = self.span.as_ref().map(|(span, _)| SpanMarker::new(marker, span));
        let places = self.rows.as_mut().iter_mut().skip(slot).zip(effects);
        for (gradient, (place, effect)) in gradients.iter().zip(places) {
            let force = match &spanned {
                Some(spanned) => spanned.generalised_force(gradient),
                None => placed.generalised_force(gradient),
            };
            *effect = eliminated.reduced_force(&force).into();
            let weighted = eliminated.modal.solve(&force.modal);
            *place = AttachedRow { modal: force.modal, weighted };
        }
    }

    fn compliance(&self, slot: usize, other: usize) -> T {
        let rows = self.rows.as_ref();
        match (rows.get(slot), rows.get(other)) {
            (Some(row), Some(other)) => row.modal.dot(&other.weighted),
            _ => T::zero(),
        }
    }

    fn reduced_force(&mut self) -> [T; 6] {
        let Some(eliminated) = &self.eliminated else { return [T::zero(); 6] };
        self.alone = eliminated.modal.solve(&self.net.modal);
        eliminated.reduced_force(&self.net).into()
    }

    fn push_net(&mut self, marker: usize, wrench: &Wrench<T>) {
        let Some(force) = self.generalised_force(marker, wrench) else { return };
        // in a step of the energy-momentum method the right-hand side is an impulse
        let share = self.span.as_ref().map_or(T::one(), |(span, _)| span.step);
        self.net.add_scaled(share, &force);
    }

    fn without_force(&mut self) {
        self.alone = self.body.undeformed();
    }

    fn modal_acceleration(&self, slot: usize) -> T {
        self.rows.as_ref().get(slot).map_or(T::zero(), |row| row.modal.dot(&self.alone))
    }

    fn subtracted_twist(&self, marker: usize) -> [Vector3<T>; 2] {
        match self.implicit {
            Some(ImplicitTerms { subtracted: Some(subtracted), .. }) => {
                self.twist(marker, &subtracted.velocities(&self.state))
            }
            _ => [Vector3::zeros(); 2],
        }
    }

    fn finish(&mut self, rigid: &[T; 6]) {
        if let Some(eliminated) = &self.eliminated {
            self.motion = eliminated.with_modes(&Vector6::from(*rigid), self.alone.clone());
        }
    }

    fn follow(&mut self, slot: usize, multiplier: T) {
        if let Some(row) = self.rows.as_ref().get(slot) {
            self.motion.modal.add_scaled(multiplier, &row.weighted);
        }
    }

    fn resulting_twist(&self, marker: usize) -> [Vector3<T>; 2] {
        self.twist(marker, &self.motion)
    }
}
