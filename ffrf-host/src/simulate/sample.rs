//! What a simulation shows at one time: the columns of its output.

use ffrf_runtime::forces::relative_angle;
use ffrf_runtime::mechanism::{
    Assembly, Constrained, EvaluatedJoint, Storage, acceleration, reaction as reaction_of_one,
};
use ffrf_runtime::{Observables, State, StepError, rotation, von_mises};
use nalgebra::{RealField, Vector3, convert};

use crate::HostModal;
use crate::mechanism::{HostMechanism, HostPorts};
use crate::scene::{Scene, SensorKind};

/// The numbers of one time, in the order of [`header`].
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// Time. Units: s.
    pub time: f64,
    /// The other columns.
    pub values: Vec<f64>,
}

/// The names of the columns, the time first.
pub fn header(scene: &Scene) -> Vec<String> {
    let mut names = vec!["t".to_owned()];
    let bodies = scene.body_names.iter().zip(scene.mechanism.bodies());
    for (name, body) in bodies {
        let mut add = |what: &str, parts: &[&str]| {
            names.extend(parts.iter().map(|part| format!("{name}.{what}.{part}")))
        };
        let modes: Vec<String> = (1..=body.mode_count()).map(|mode| mode.to_string()).collect();
        let modes: Vec<&str> = modes.iter().map(String::as_str).collect();
        add("position", &AXES);
        add("orientation", &["w", "x", "y", "z"]);
        add("modal_coordinates", &modes);
        add("velocity", &AXES);
        add("angular_velocity", &AXES);
        add("modal_rates", &modes);
    }
    for sensor in &scene.sensors {
        names.extend(sensor.kind.columns().iter().map(|ending| format!("{}{ending}", sensor.name)));
    }
    names.extend(
        ["energy.kinetic", "energy.elastic", "energy.potential", "drift.position", "drift.velocity"]
            .map(str::to_owned),
    );
    names
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// The sample of a state. `angles`: those of angle sensors at the sample before, continued over turns.
pub(super) fn sample(
    scene: &Scene,
    time: f64,
    state: &[State<HostModal>],
    angles: &mut [Option<f64>],
) -> Result<Sample, StepError> {
    let mut values = Vec::new();
    for body in state {
        values.extend_from_slice(body.position.as_slice());
        values.extend_from_slice(&rotation::euler_parameters(&body.orientation));
        values.extend_from_slice(body.modal_coordinates.0.as_slice());
        values.extend_from_slice(body.velocity.as_slice());
        values.extend_from_slice(body.angular_velocity.as_slice());
        values.extend_from_slice(body.modal_rates.0.as_slice());
    }
    let mechanism = &scene.mechanism;
    Constrained(mechanism).evaluate(time, state.to_vec(), None, |ports, storage| {
        for (sensor, angle) in scene.sensors.iter().zip(angles) {
            read(&sensor.kind, mechanism, ports, storage, angle, &mut values);
        }
        values.extend(energies(mechanism, state, ports));
        values.extend(residuals(storage));
    })?;
    Ok(Sample { time, values })
}

/// Appends what a sensor measures. `angle`: that of an angle sensor at the sample before, continued over turns.
pub(crate) fn read<T: RealField + Copy>(
    kind: &SensorKind,
    mechanism: &HostMechanism<T>,
    ports: &HostPorts<'_, T>,
    storage: &Storage<'_, T>,
    angle: &mut Option<T>,
    values: &mut Vec<T>,
) {
    match kind {
        SensorKind::Position(at) => values.extend_from_slice(at.cast().motion(ports).position.as_slice()),
        SensorKind::Velocity(at) => values.extend_from_slice(at.cast().motion(ports).velocity.as_slice()),
        SensorKind::Acceleration(at) => values.extend_from_slice(acceleration(&at.cast(), ports).as_slice()),
        SensorKind::Orientation(at) => {
            values.extend(rotation::euler_parameters(&at.cast().motion(ports).orientation))
        }
        SensorKind::Angle(joint) => {
            let now = storage.joints[*joint]
                .as_ref()
                .map_or_else(T::zero, |joint| relative_angle(&joint.ends[0], &joint.ends[1]));
            let turn = T::two_pi();
            let continued = angle.map_or(now, |before| now + turn * ((before - now) / turn).round());
            *angle = Some(continued);
            values.push(continued);
        }
        SensorKind::ReactionForce(joints) => {
            values.extend_from_slice(reaction(mechanism, storage, joints).0.as_slice());
        }
        SensorKind::ReactionMoment(joints) => {
            values.extend_from_slice(reaction(mechanism, storage, joints).1.as_slice());
        }
        SensorKind::SectionForce { body, marker } => {
            let coordinates = ports.0[*body].state.modal_coordinates.0.as_slice();
            let rows = marker.force.iter().chain(&marker.moment);
            values.extend(rows.map(|row| product(row, coordinates)));
        }
        SensorKind::Stress { body, marker } => {
            let coordinates = ports.0[*body].state.modal_coordinates.0.as_slice();
            let stress = marker.stress.each_ref().map(|row| product(row, coordinates));
            values.extend_from_slice(&stress);
            values.push(von_mises(&stress));
        }
    }
}

/// A row of constants times modal coordinates.
fn product<T: RealField + Copy>(row: &HostModal, coordinates: &[T]) -> T {
    let terms = row.0.iter().zip(coordinates);
    terms.fold(T::zero(), |sum, (entry, q)| sum + convert::<f64, T>(*entry) * *q)
}

/// Force and moment of joints on their second body, at the attachment there.
fn reaction<T: RealField + Copy>(
    mechanism: &HostMechanism<T>,
    storage: &Storage<'_, T>,
    joints: &[usize],
) -> (Vector3<T>, Vector3<T>) {
    let plan = mechanism.plan();
    let mut sum = (Vector3::zeros(), Vector3::zeros());
    for joint in joints {
        let wrench = reaction_of_one(&plan, storage, *joint);
        sum.0 += wrench.force;
        sum.1 += wrench.moment;
    }
    sum
}

/// Kinetic, elastic and potential energy; the last holds gravity and force elements. Units: J.
fn energies(mechanism: &HostMechanism, state: &[State<HostModal>], ports: &HostPorts<'_>) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (body, state) in mechanism.bodies().iter().zip(state) {
        let q = &state.modal_coordinates;
        sum[0] += body.kinetic_energy(q, &state.body_velocity(), &state.angular_velocity, &state.modal_rates);
        sum[1] += body.elastic_energy(q);
        let moment = state.position * body.mass() + state.to_inertial(&body.first_mass_moment(q));
        sum[2] -= mechanism.gravity().dot(&moment);
    }
    sum[2] += mechanism.elements().iter().map(|element| element.energy(ports)).sum::<f64>();
    sum
}

/// Kinetic, elastic and potential energy together. Units: J.
pub(crate) fn total_energy(
    mechanism: &HostMechanism,
    state: &[State<HostModal>],
    ports: &HostPorts<'_>,
) -> f64 {
    energies(mechanism, state, ports).iter().sum()
}

/// Largest residual of positions and velocities.
fn residuals(storage: &Storage<'_, f64>) -> [f64; 2] {
    let mut largest = [0.0_f64; 2];
    for [position, velocity] in storage.evaluated().flat_map(EvaluatedJoint::residuals) {
        largest[0] = largest[0].max(position.abs());
        largest[1] = largest[1].max(velocity.abs());
    }
    largest
}
