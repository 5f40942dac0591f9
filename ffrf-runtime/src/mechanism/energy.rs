//! Energy and momentum of the bodies of a mechanism.

use nalgebra::{RealField, Vector3};

use crate::body::{FlexibleBody, ModalVector, Motion, State};

/// Energy of a mechanism in one state. Units: J.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energy<T = f64> {
    /// Of the motion of all bodies.
    pub kinetic: T,
    /// Of their deformation, ½ qᵀ K q.
    pub elastic: T,
    /// Of gravity, zero at the inertial origin, and what force elements store.
    pub potential: T,
}

/// Momentum of a mechanism in one state. Frame: inertial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Momentum<T = f64> {
    /// Shape: 3. Units: N s.
    pub linear: Vector3<T>,
    /// About the inertial origin. Shape: 3. Units: N m s.
    pub angular: Vector3<T>,
}

impl<T: RealField + Copy> Energy<T> {
    /// No energy.
    pub fn none() -> Self {
        Self { kinetic: T::zero(), elastic: T::zero(), potential: T::zero() }
    }

    /// All of it.
    pub fn total(&self) -> T {
        self.kinetic + self.elastic + self.potential
    }

    /// That of bodies in uniform gravity (m/s², inertial).
    pub fn of<'a, B: FlexibleBody<T> + 'a>(
        bodies: impl Iterator<Item = (&'a B, &'a State<B::Modal, T>)>,
        gravity: &Vector3<T>,
    ) -> Self
    where
        B::Modal: 'a,
        T: 'a,
    {
        let mut sum = Self::none();
        bodies.for_each(|(body, state)| sum.add_body(body, state, gravity));
        sum
    }

    /// Adds that of a body in uniform gravity (m/s², inertial).
    pub fn add_body<B: FlexibleBody<T>>(
        &mut self,
        body: &B,
        state: &State<B::Modal, T>,
        gravity: &Vector3<T>,
    ) {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = state;
        let prepared = body.prepare(modal_coordinates, angular_velocity, modal_rates);
        let motion = state.velocities();
        let half: T = nalgebra::convert(0.5);
        self.kinetic += prepared.mass_times(&body.modal_mass(), &motion).power(&motion) * half;
        self.elastic += body.stiffness().product(modal_coordinates).dot(modal_coordinates) * half;
        let moment = state.position * prepared.mass + state.to_inertial(&prepared.first_moment);
        self.potential -= gravity.dot(&moment);
    }
}

impl<T: RealField + Copy> Momentum<T> {
    /// No momentum.
    pub fn none() -> Self {
        Self { linear: Vector3::zeros(), angular: Vector3::zeros() }
    }

    /// That of bodies.
    pub fn of<'a, B: FlexibleBody<T> + 'a>(
        bodies: impl Iterator<Item = (&'a B, &'a State<B::Modal, T>)>,
    ) -> Self
    where
        B::Modal: 'a,
        T: 'a,
    {
        let mut sum = Self::none();
        bodies.for_each(|(body, state)| sum.add_body(body, state));
        sum
    }

    /// Adds that of a body.
    pub fn add_body<B: FlexibleBody<T>>(&mut self, body: &B, state: &State<B::Modal, T>) {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = state;
        let motion: Motion<B::Modal, T> = state.velocities();
        let prepared = body.prepare(modal_coordinates, angular_velocity, modal_rates);
        let own = prepared.mass_times(&body.modal_mass(), &motion);
        let linear = state.to_inertial(&own.force);
        self.linear += linear;
        self.angular += state.to_inertial(&own.moment) + state.position.cross(&linear);
    }
}
