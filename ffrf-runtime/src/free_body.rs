//! A body that moves freely: kernels, state and time in one place, with its observables.

use nalgebra::{RealField, SVector, UnitQuaternion, Vector3};

use crate::{FlexibleBody, Load, Marker, State, StepError, StepReport, step_linearly_implicit, step_rk4};

/// A flexible body without joints, its state and its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeBody<B, const M: usize, const N: usize, T: RealField + Copy = f64> {
    /// The kernels of the body.
    pub body: B,
    /// Where the body is and how it moves.
    pub state: State<M, T>,
    /// Time of the state. Units: s.
    pub time: T,
}

impl<B, const M: usize, const N: usize, T> FreeBody<B, M, N, T>
where
    B: FlexibleBody<M, N, T>,
    T: RealField + Copy,
{
    /// The body at rest at the inertial origin, undeformed, at time zero.
    pub fn new(body: B) -> Self {
        const { assert!(N == 6 + M, "a body with M modes has N = 6 + M velocities") };
        Self { body, state: State::at_rest(), time: T::zero() }
    }

    /// The same body in `state`.
    pub fn with_state(mut self, state: State<M, T>) -> Self {
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
    pub fn with_deformation(mut self, q: SVector<T, M>, q_dot: SVector<T, M>) -> Self {
        self.state.modal_coordinates = q;
        self.state.modal_rates = q_dot;
        self
    }

    /// Advances by one explicit step of order 4, see [`step_rk4`].
    ///
    /// Units: `step` s. Errors: see [`StepError`]; state and time are then unchanged. Panics: never.
    pub fn step_rk4<L: Load<B, M, N, T>>(&mut self, step: T, load: &L) -> Result<StepReport<T>, StepError> {
        let (state, report) = step_rk4(&self.body, &self.state, self.time, step, load)?;
        self.state = state;
        self.time += step;
        Ok(report)
    }

    /// Advances by one linearly implicit step of order 2, see [`step_linearly_implicit`].
    ///
    /// Units: `step` s. Errors: see [`StepError`]; state and time are then unchanged. Panics: never.
    pub fn step_linearly_implicit<L: Load<B, M, N, T>>(
        &mut self,
        step: T,
        load: &L,
    ) -> Result<StepReport<T>, StepError> {
        let (state, report) = step_linearly_implicit(&self.body, &self.state, self.time, step, load)?;
        self.state = state;
        self.time += step;
        Ok(report)
    }

    /// Generalised force [f̄; τ; f] of `load` now. Shape: N. Frame: body. Panics: never.
    pub fn generalised_force<L: Load<B, M, N, T>>(&self, load: &L) -> SVector<T, N> {
        let mut force = SVector::zeros();
        load.add_to(&self.body, self.time, &self.state, &mut force);
        force
    }

    /// Accelerations [α; ω̇; q̈] under `load` now. Shape: N. Frame: body. Panics: never.
    pub fn acceleration<L: Load<B, M, N, T>>(&self, load: &L) -> SVector<T, N> {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &self.state;
        let force = self.generalised_force(load);
        self.body.forward_dynamics(modal_coordinates, angular_velocity, modal_rates, &force)
    }

    /// Kinetic energy. Units: J. Panics: never.
    pub fn kinetic_energy(&self) -> T {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &self.state;
        self.body.kinetic_energy(
            modal_coordinates,
            &self.state.body_velocity(),
            angular_velocity,
            modal_rates,
        )
    }

    /// Elastic energy ½ qᵀ K_ff q. Units: J. Panics: never.
    pub fn elastic_energy(&self) -> T {
        self.body.elastic_energy(&self.state.modal_coordinates)
    }

    /// Potential energy -m g · c in uniform gravity, zero at the inertial origin.
    ///
    /// Units: J; `gravity` m/s², inertial. Panics: never.
    pub fn potential_energy(&self, gravity: &Vector3<T>) -> T {
        // m c = m p + A (m r): no division by the mass
        let moment =
            self.state.position * self.body.mass() + self.state.to_inertial(&self.first_mass_moment());
        -gravity.dot(&moment)
    }

    /// Linear momentum. Shape: 3. Units: N s. Frame: inertial. Panics: never.
    pub fn linear_momentum(&self) -> Vector3<T> {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &self.state;
        let velocity = self.state.body_velocity();
        let momentum = self.body.linear_momentum(modal_coordinates, &velocity, angular_velocity, modal_rates);
        self.state.to_inertial(&momentum)
    }

    /// Angular momentum about the inertial origin. Shape: 3. Units: N m s. Frame: inertial. Panics: never.
    pub fn angular_momentum(&self) -> Vector3<T> {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &self.state;
        let velocity = self.state.body_velocity();
        let about_frame =
            self.body.angular_momentum(modal_coordinates, &velocity, angular_velocity, modal_rates);
        self.state.position.cross(&self.linear_momentum()) + self.state.to_inertial(&about_frame)
    }

    /// Position of the centre of mass, p + A r(q). Shape: 3. Units: m. Frame: inertial. Panics: never.
    pub fn centre_of_mass(&self) -> Vector3<T> {
        self.state.position + self.state.to_inertial(&self.first_mass_moment()) / self.body.mass()
    }

    /// Position of a marker. Shape: 3. Units: m. Frame: inertial. Panics: never.
    pub fn marker_position(&self, marker: &Marker<M, T>) -> Vector3<T> {
        let arm = self.body.marker_position(marker, &self.state.modal_coordinates);
        self.state.position + self.state.to_inertial(&arm)
    }

    /// Velocity of a marker. Shape: 3. Units: m/s. Frame: inertial. Panics: never.
    pub fn marker_velocity(&self, marker: &Marker<M, T>) -> Vector3<T> {
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &self.state;
        let velocity = self.state.body_velocity();
        let velocity =
            self.body.marker_velocity(marker, modal_coordinates, &velocity, angular_velocity, modal_rates);
        self.state.to_inertial(&velocity)
    }

    /// Orientation of the material at a marker: A times the rotation by the small rotation vector there.
    ///
    /// Maps components in the marker's frame to inertial components. Panics: never.
    pub fn marker_orientation(&self, marker: &Marker<M, T>) -> UnitQuaternion<T> {
        let small = UnitQuaternion::from_scaled_axis(marker.small_rotation(&self.state.modal_coordinates));
        self.state.orientation * small
    }

    fn first_mass_moment(&self) -> Vector3<T> {
        self.body.first_mass_moment(&self.state.modal_coordinates)
    }
}
