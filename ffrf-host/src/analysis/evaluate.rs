//! The equations of a mechanism about a state, with their derivative in one direction.

use ffrf_runtime::mechanism::{Assembly as _, Constrained};
use ffrf_runtime::{Increment, State, StepError};
use nalgebra::{DVector, Quaternion, RealField, UnitQuaternion, convert};
use num_dual::Dual64;

use super::spin::{Spin, States};
use crate::mechanism::HostIncrement;
use crate::scene::{Scene, SensorKind};
use crate::simulate::read_sensor;
use crate::{HostMechanism, HostModal};

/// A mechanism in a state, ready for derivatives.
pub(super) struct Point<'a> {
    pub(super) mechanism: &'a HostMechanism,
    dual: HostMechanism<Dual64>,
    sensors: Vec<&'a SensorKind>,
    pub(super) time: f64,
    pub(super) state: States,
    /// The steady rotation that rates are seen from, if any.
    pub(super) spin: Option<Spin>,
}

/// What a derivative can be asked by, besides places and velocities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Input {
    /// A force or moment of a scene, by its element: it grows along its own direction.
    Element(usize),
    /// The input of an actuator.
    Actuator(usize),
}

/// Rates in the chart about a state, rates of residuals and sensors, each with its derivative.
pub(super) struct Evaluated {
    pub(super) place_rates: DVector<Dual64>,
    pub(super) accelerations: DVector<Dual64>,
    pub(super) velocity_residuals: Vec<Dual64>,
    pub(super) outputs: Vec<Dual64>,
}

/// The part that is a derivative.
pub(super) fn slope(numbers: &DVector<Dual64>) -> DVector<f64> {
    numbers.map(|number| number.eps)
}

/// The part that is a value.
pub(super) fn value(numbers: &DVector<Dual64>) -> DVector<f64> {
    numbers.map(|number| number.re)
}

impl<'a> Point<'a> {
    pub(super) fn new(scene: &'a Scene, mechanism: &'a HostMechanism, time: f64, state: States) -> Self {
        let sensors = scene.sensors.iter().map(|sensor| &sensor.kind).collect();
        Self { mechanism, dual: mechanism.cast(), sensors, time, state, spin: None }
    }

    /// Velocities of each body: 6 and its modes.
    pub(super) fn sizes(&self) -> impl Iterator<Item = usize> + '_ {
        self.mechanism.bodies().iter().map(|body| 6 + body.mode_count())
    }

    /// Velocities of all bodies.
    pub(super) fn size(&self) -> usize {
        self.sizes().sum()
    }

    /// Everything at the state, with the derivative in the direction of `places` and `velocities`.
    pub(super) fn evaluate(
        &self,
        places: &DVector<f64>,
        velocities: &DVector<f64>,
    ) -> Result<Evaluated, StepError> {
        self.evaluate_with(&self.dual, places, velocities)
    }

    /// The derivative by an input.
    pub(super) fn evaluate_input(&self, input: Input) -> Result<Evaluated, StepError> {
        let mut mechanism = self.mechanism.cast();
        let change = Dual64::new(0.0, 1.0);
        match input {
            Input::Element(index) => {
                let mut elements = mechanism.elements().to_vec();
                if let Some(element) = elements.get_mut(index) {
                    element.kind.grow(change);
                }
                mechanism = mechanism.with_elements(elements);
            }
            Input::Actuator(index) => {
                let mut actuators = mechanism.actuators().to_vec();
                if let Some(actuator) = actuators.get_mut(index) {
                    actuator.added += change;
                }
                mechanism = mechanism.with_actuators(actuators);
            }
        }
        let none = DVector::zeros(self.size());
        self.evaluate_with(&mechanism, &none, &none)
    }

    fn evaluate_with(
        &self,
        mechanism: &HostMechanism<Dual64>,
        places: &DVector<f64>,
        velocities: &DVector<f64>,
    ) -> Result<Evaluated, StepError> {
        let origin: States<Dual64> = self.state.iter().map(cast_state).collect();
        let direction = |numbers: &DVector<f64>| numbers.map(|slope| Dual64::new(0.0, slope));
        let increment = increment(self.sizes(), &direction(places), &direction(velocities));
        let state = mechanism.retract(&origin, &increment);
        let time = convert(self.time);
        let moved = state.clone();
        let mut evaluated = Constrained(mechanism).evaluate(time, state, None, |ports, storage| {
            let (place_rates, accelerations) = flatten(&mechanism.collect(ports, &increment));
            let rows =
                || storage.evaluated().flat_map(|joint| joint.rows.iter().map(move |row| (row, &joint.ends)));
            let mut outputs = Vec::new();
            for sensor in &self.sensors {
                read_sensor(sensor, mechanism, ports, storage, &mut None, &mut outputs);
            }
            Evaluated {
                place_rates,
                accelerations,
                velocity_residuals: rows()
                    .map(|(row, [first, second])| row.velocity(first, second))
                    .collect(),
                outputs,
            }
        })?;
        if let Some(spin) = &self.spin {
            let (places, velocities) = flatten(&spin.field(&moved, &increment));
            evaluated.place_rates -= places;
            evaluated.accelerations -= velocities;
        }
        Ok(evaluated)
    }
}

/// A state in another number type.
pub(super) fn cast_state<T: RealField + Copy>(state: &State<HostModal>) -> State<HostModal<T>, T> {
    State {
        position: state.position.map(convert),
        orientation: UnitQuaternion::new_unchecked(Quaternion::from(state.orientation.coords.map(convert))),
        modal_coordinates: state.modal_coordinates.cast(),
        velocity: state.velocity.map(convert),
        angular_velocity: state.angular_velocity.map(convert),
        modal_rates: state.modal_rates.cast(),
    }
}

/// An increment from a vector of places and one of velocities, body by body: position, rotation, modes.
pub(super) fn increment<T: RealField + Copy>(
    sizes: impl Iterator<Item = usize>,
    places: &DVector<T>,
    velocities: &DVector<T>,
) -> HostIncrement<T> {
    let mut start = 0;
    let bodies = sizes.map(|size| {
        let vector =
            |numbers: &DVector<T>, offset: usize| numbers.fixed_rows::<3>(start + offset).into_owned();
        let modal = |numbers: &DVector<T>| HostModal(numbers.rows(start + 6, size - 6).into_owned());
        let body = Increment {
            position: vector(places, 0),
            rotation: vector(places, 3),
            modal_coordinates: modal(places),
            velocity: vector(velocities, 0),
            angular_velocity: vector(velocities, 3),
            modal_rates: modal(velocities),
        };
        start += size;
        body
    });
    HostIncrement(bodies.collect())
}

/// The reverse of [`increment`].
pub(super) fn flatten<T: RealField + Copy>(increment: &HostIncrement<T>) -> (DVector<T>, DVector<T>) {
    let (mut places, mut velocities) = (Vec::new(), Vec::new());
    for body in &increment.0 {
        places.extend_from_slice(body.position.as_slice());
        places.extend_from_slice(body.rotation.as_slice());
        places.extend_from_slice(body.modal_coordinates.0.as_slice());
        velocities.extend_from_slice(body.velocity.as_slice());
        velocities.extend_from_slice(body.angular_velocity.as_slice());
        velocities.extend_from_slice(body.modal_rates.0.as_slice());
    }
    (DVector::from_vec(places), DVector::from_vec(velocities))
}
