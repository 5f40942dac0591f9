//! Bodies and mechanisms to be sent to the extremes, in both number types.

use std::path::Path;

use ffrf::mechanism::{Assembly, Constrained};
use ffrf::nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use ffrf::{Observables, RigidBody, State, StepError, StepReport, step_linearly_implicit, step_rk4};
use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;
use ffrf_host::{HostMechanism, HostModal};

use crate::table::Real;

ffrf::flexible_body! {
    /// The connecting rod of the examples, compiled for every number type.
    pub struct Rod { model: "models/conrod.ffrf.json", modes: ..4, scalar: generic }
}

/// Moments of inertia of [`brick`]: the second axis is the intermediate one. Units: kg m².
pub const PRINCIPAL: [f64; 3] = [1.0, 2.0, 2.5];

/// A rigid body of 1 kg about its centre of mass.
pub fn brick<T: Real>() -> RigidBody<T> {
    let principal = Vector3::from(PRINCIPAL).map(T::of);
    RigidBody::new(T::one(), Vector3::zeros(), Matrix3::from_diagonal(&principal))
}

/// The states of all bodies of a scene.
pub type States<T> = Vec<State<HostModal<T>, T>>;

/// A mechanism and its state, assembled in double precision.
pub struct Setting<T: Real> {
    /// The mechanism.
    pub mechanism: HostMechanism<T>,
    /// Its state now.
    pub states: States<T>,
    /// Time of the state. Units: s.
    pub time: T,
}

/// The scene of a text; models are looked for in the `models` folder.
pub fn scene(text: &str) -> Scene {
    let file = SceneFile::parse(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/scenes");
    Scene::compose(&file, &folder).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

impl<T: Real> Setting<T> {
    /// A scene in its initial state.
    pub fn of(text: &str) -> Self {
        let scene = scene(text);
        let (states, _) = scene.assembled().unwrap_or_else(|error| panic!("{error}\n{text}"));
        let mechanism = scene.mechanism.cast::<T>();
        let states = mechanism.bodies().iter().zip(&states).map(|(body, state)| {
            let mut cast = State::at_rest(body);
            cast.set_numbers(&mut state.numbers().map(T::of));
            cast
        });
        let states = states.collect();
        Self { mechanism, states, time: T::zero() }
    }

    /// One step: RK4, or linearly implicit. Units: s.
    pub fn step(&mut self, step: T, implicit: bool) -> Result<StepReport<T>, StepError> {
        let system = Constrained(&self.mechanism);
        let (states, report) = if implicit {
            step_linearly_implicit(&system, &self.states, self.time, step)?
        } else {
            step_rk4(&system, &self.states, self.time, step)?
        };
        self.states = states;
        self.time += step;
        Ok(report)
    }

    /// Kinetic, elastic and potential energy, in double precision. Units: J.
    pub fn energy(&self) -> f64 {
        let parts = self.mechanism.bodies().iter().zip(&self.states).map(|(body, state)| {
            let State { modal_coordinates: q, angular_velocity, modal_rates, .. } = state;
            let moment = state.position * body.mass() + state.to_inertial(&body.first_mass_moment(q));
            let kinetic = body.kinetic_energy(q, &state.body_velocity(), angular_velocity, modal_rates);
            (kinetic + body.elastic_energy(q) - self.mechanism.gravity().dot(&moment)).double()
        });
        parts.sum()
    }

    /// Kinetic energy, in double precision. Units: J.
    pub fn kinetic_energy(&self) -> f64 {
        let parts = self.mechanism.bodies().iter().zip(&self.states).map(|(body, state)| {
            let State { modal_coordinates: q, angular_velocity, modal_rates, .. } = state;
            body.kinetic_energy(q, &state.body_velocity(), angular_velocity, modal_rates).double()
        });
        parts.sum()
    }

    /// The numbers of all states, in double precision.
    pub fn numbers(&self) -> Vec<f64> {
        self.states.iter().flat_map(State::numbers).map(T::double).collect()
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        self.mechanism.is_finite(&self.states)
    }
}

/// An orientation in double precision, as it is: not of unit norm to more digits than its number type has.
pub fn double<T: Real>(orientation: &UnitQuaternion<T>) -> UnitQuaternion<f64> {
    let [x, y, z, w]: [T; 4] = orientation.coords.into();
    UnitQuaternion::new_unchecked(Quaternion::new(w.double(), x.double(), y.double(), z.double()))
}

/// The largest of some sizes; not a number if one of them is not.
pub fn largest(sizes: impl IntoIterator<Item = f64>) -> f64 {
    sizes.into_iter().fold(0.0, |most, size| if size.is_nan() || size > most { size } else { most })
}
