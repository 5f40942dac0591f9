//! A body that moves freely: kernels, state and time in one place, with its observables.

use nalgebra::{RealField, UnitQuaternion, Vector3};

use super::{
    FlexibleBody, FreeSystem, GeneralisedForce, Load, Marker, MarkerMotion, Motion, Observables,
    PlacedMarker, State,
};
use crate::integrators::{StepError, StepReport, advance_linearly_implicit, advance_rk4};

/// A flexible body without joints, its state and its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeBody<B: FlexibleBody<T>, T: RealField + Copy = f64> {
    /// The kernels of the body.
    pub body: B,
    /// Where the body is and how it moves.
    pub state: State<B::Modal, T>,
    /// Time of the state. Units: s.
    pub time: T,
}

impl<B: FlexibleBody<T>, T: RealField + Copy> FreeBody<B, T> {
    /// The body at rest at the inertial origin, undeformed, at time zero.
    pub fn new(body: B) -> Self {
        let state = State::at_rest(&body);
        Self { body, state, time: T::zero() }
    }

    /// The same body in `state`.
    pub fn with_state(mut self, state: State<B::Modal, T>) -> Self {
        self.state = state;
        self
    }

    /// The same body with its frame origin at `position`. Units: m. Frame: inertial.
    pub fn with_position(mut self, position: Vector3<T>) -> Self {
        self.state.position = position;
        self
    }

    /// The same body with this orientation (body to inertial components).
    pub fn with_orientation(mut self, orientation: UnitQuaternion<T>) -> Self {
        self.state.orientation = orientation;
        self
    }

    /// The same body with this velocity of the frame origin. Units: m/s. Frame: inertial.
    pub fn with_velocity(mut self, velocity: Vector3<T>) -> Self {
        self.state.velocity = velocity;
        self
    }

    /// The same body with this angular velocity. Units: rad/s. Frame: body.
    pub fn with_spin(mut self, angular_velocity: Vector3<T>) -> Self {
        self.state.angular_velocity = angular_velocity;
        self
    }

    /// The same body with this deformation and these rates. Units: those of the modes, and per second.
    pub fn with_deformation(mut self, q: B::Modal, q_dot: B::Modal) -> Self {
        self.state.modal_coordinates = q;
        self.state.modal_rates = q_dot;
        self
    }

    /// Advances by one explicit step of order 4, see [`step_rk4`](crate::step_rk4).
    ///
    /// Units: `step` s. Errors: see [`StepError`]; state and time are then unchanged.
    pub fn step_rk4<L>(&mut self, step: T, load: &L) -> Result<StepReport<T>, StepError>
    where
        L: Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T>,
    {
        let system = FreeSystem { body: &self.body, load };
        let report = advance_rk4(&system, &mut self.state, self.time, step)?;
        self.time += step;
        Ok(report)
    }

    /// Advances by one linearly implicit step of order 2, see [`step_linearly_implicit`](crate::step_linearly_implicit).
    ///
    /// Units: `step` s. Errors: see [`StepError`]; state and time are then unchanged.
    pub fn step_linearly_implicit<L>(&mut self, step: T, load: &L) -> Result<StepReport<T>, StepError>
    where
        L: Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T>,
    {
        let system = FreeSystem { body: &self.body, load };
        let report = advance_linearly_implicit(&system, &mut self.state, self.time, step)?;
        self.time += step;
        Ok(report)
    }

    /// Generalised force of `load` now. Frame: body.
    pub fn generalised_force<L>(&self, load: &L) -> GeneralisedForce<B::Modal, T>
    where
        L: Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T>,
    {
        let mut force = GeneralisedForce::zeros(&self.state.modal_coordinates);
        load.add_to(&self.body, self.time, &self.state, &mut force);
        force
    }

    /// Accelerations under `load` now. Frame: body.
    pub fn acceleration<L>(&self, load: &L) -> Motion<B::Modal, T>
    where
        L: Load<B, State<B::Modal, T>, GeneralisedForce<B::Modal, T>, T>,
    {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &self.state;
        let force = self.generalised_force(load);
        self.body.forward_dynamics(modal_coordinates, angular_velocity, modal_rates, &force)
    }

    /// Place and motion of a marker in space.
    pub fn marker_motion(&self, marker: &Marker<B::Modal, T>) -> MarkerMotion<T> {
        PlacedMarker::new(marker, &self.state).motion(&self.state)
    }

    /// Position of a marker. Shape: 3. Units: m. Frame: inertial.
    pub fn marker_position(&self, marker: &Marker<B::Modal, T>) -> Vector3<T> {
        self.state.position + self.state.to_inertial(&marker.position(&self.state.modal_coordinates))
    }

    /// Velocity of a marker. Shape: 3. Units: m/s. Frame: inertial.
    pub fn marker_velocity(&self, marker: &Marker<B::Modal, T>) -> Vector3<T> {
        self.marker_motion(marker).velocity
    }

    /// Orientation of the material at a marker; maps components in the marker's triad to inertial components.
    pub fn marker_orientation(&self, marker: &Marker<B::Modal, T>) -> UnitQuaternion<T> {
        self.marker_motion(marker).orientation
    }
}

impl<B: Observables<T>, T: RealField + Copy> FreeBody<B, T> {
    /// Kinetic energy. Units: J.
    pub fn kinetic_energy(&self) -> T {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &self.state;
        let velocity = self.state.body_velocity();
        self.body.kinetic_energy(modal_coordinates, &velocity, angular_velocity, modal_rates)
    }

    /// Elastic energy ½ qᵀ K_ff q. Units: J.
    pub fn elastic_energy(&self) -> T {
        self.body.elastic_energy(&self.state.modal_coordinates)
    }

    /// Potential energy -m g · c in uniform gravity, zero at the inertial origin.
    ///
    /// Units: J; `gravity` m/s², inertial.
    pub fn potential_energy(&self, gravity: &Vector3<T>) -> T {
        // m c = m p + A (m r): no division by the mass
        let moment =
            self.state.position * self.body.mass() + self.state.to_inertial(&self.first_mass_moment());
        -gravity.dot(&moment)
    }

    /// Linear momentum. Shape: 3. Units: N s. Frame: inertial.
    pub fn linear_momentum(&self) -> Vector3<T> {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &self.state;
        let velocity = self.state.body_velocity();
        let momentum = self.body.linear_momentum(modal_coordinates, &velocity, angular_velocity, modal_rates);
        self.state.to_inertial(&momentum)
    }

    /// Angular momentum about the inertial origin. Shape: 3. Units: N m s. Frame: inertial.
    pub fn angular_momentum(&self) -> Vector3<T> {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &self.state;
        let velocity = self.state.body_velocity();
        let about_frame =
            self.body.angular_momentum(modal_coordinates, &velocity, angular_velocity, modal_rates);
        self.state.position.cross(&self.linear_momentum()) + self.state.to_inertial(&about_frame)
    }

    /// Position of the centre of mass, p + A r(q). Shape: 3. Units: m. Frame: inertial.
    pub fn centre_of_mass(&self) -> Vector3<T> {
        self.state.position + self.state.to_inertial(&self.first_mass_moment()) / self.body.mass()
    }

    fn first_mass_moment(&self) -> Vector3<T> {
        self.body.first_mass_moment(&self.state.modal_coordinates)
    }
}
