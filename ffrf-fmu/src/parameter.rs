//! The parameters of an FMU: keys of the scene file that are numbers.

use ffrf_host::scene::Scene;
use ffrf_host::scene::file::{BodyTable, ForceTable, SceneFile};

/// A number of a scene file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// `simulation.gravity`, and which component.
    Gravity(usize),
    /// `simulation.step`.
    Step,
    /// `simulation.tolerance`.
    Tolerance,
    /// A number of a body's initial state.
    Body(usize, BodyKey, usize),
    /// A number of a force.
    Force(usize, ForceKey, usize),
}

/// What a body begins with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // the keys of scene files, by their names
pub enum BodyKey {
    Position,
    Orientation,
    Velocity,
    AngularVelocity,
    ModalCoordinates,
    ModalRates,
}

/// A number of a force element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // the keys of scene files, by their names
pub enum ForceKey {
    Stiffness,
    Damping,
    Rest,
    Limit,
    Speed,
    Coefficient,
    Radius,
    Gain,
    Value,
    StiffnessMatrix,
    DampingMatrix,
}

/// A parameter as other tools see it: its key, its unit if that is the same in all scenes, its start.
pub(crate) struct Found {
    pub(crate) parameter: Parameter,
    pub(crate) name: String,
    pub(crate) unit: &'static str,
    pub(crate) start: f64,
}

const AXES: [&str; 3] = ["x", "y", "z"];
const QUATERNION: [&str; 4] = ["w", "x", "y", "z"];

/// The parameters of a scene.
pub(crate) fn parameters(file: &SceneFile, scene: &Scene) -> Vec<Found> {
    let mut found = Vec::new();
    let mut add = |parameter, name: String, unit, start| found.push(Found { parameter, name, unit, start });
    for (k, axis) in AXES.iter().enumerate() {
        add(Parameter::Gravity(k), format!("simulation.gravity.{axis}"), "m/s2", file.simulation.gravity[k]);
    }
    if let Some(step) = file.simulation.step {
        add(Parameter::Step, "simulation.step".to_owned(), "s", step);
    }
    if let Some(tolerance) = file.simulation.tolerance {
        add(Parameter::Tolerance, "simulation.tolerance".to_owned(), "", tolerance);
    }
    for (body, ((name, table), flexible)) in file.bodies.iter().zip(scene.mechanism.bodies()).enumerate() {
        let mut add = |key, what: &str, unit, endings: &[String], start: &[f64]| {
            for (k, (ending, start)) in endings.iter().zip(start).enumerate() {
                let name = format!("bodies.{name}.{what}.{ending}");
                add(Parameter::Body(body, key, k), name, unit, *start);
            }
        };
        let axes = AXES.map(str::to_owned);
        let modes: Vec<String> = (1..=flexible.mode_count()).map(|mode| mode.to_string()).collect();
        let modal = |given: &Option<Vec<f64>>| given.clone().unwrap_or_else(|| vec![0.0; modes.len()]);
        let orientation = table.orientation.unwrap_or(UPRIGHT);
        add(BodyKey::Position, "position", "m", &axes, &table.position);
        add(BodyKey::Orientation, "orientation", "", &QUATERNION.map(str::to_owned), &orientation);
        add(BodyKey::Velocity, "velocity", "m/s", &axes, &table.velocity);
        add(BodyKey::AngularVelocity, "angular_velocity", "rad/s", &axes, &table.angular_velocity);
        add(BodyKey::ModalCoordinates, "modal_coordinates", "", &modes, &modal(&table.modal_coordinates));
        add(BodyKey::ModalRates, "modal_rates", "", &modes, &modal(&table.modal_rates));
    }
    for (force, (name, table)) in file.forces.iter().enumerate() {
        for (key, what, endings) in FORCE_KEYS {
            // what a table does not say may not be said of its kind; a gain has a default
            let default = (*key == ForceKey::Gain && table.kind == "actuator").then_some(1.0);
            for (k, ending) in endings.iter().enumerate() {
                if let Some(start) = force_number(&mut table.clone(), *key, k).map(|n| *n).or(default) {
                    let parameter = Parameter::Force(force, *key, k);
                    add(parameter, format!("forces.{name}.{what}{ending}"), "", start);
                }
            }
        }
    }
    found
}

const UPRIGHT: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

const FORCE_KEYS: &[(ForceKey, &str, &[&str])] = &[
    (ForceKey::Stiffness, "stiffness", &[""]),
    (ForceKey::Damping, "damping", &[""]),
    (ForceKey::Rest, "rest", &[""]),
    (ForceKey::Limit, "limit", &[""]),
    (ForceKey::Speed, "speed", &[""]),
    (ForceKey::Coefficient, "coefficient", &[""]),
    (ForceKey::Radius, "radius", &[""]),
    (ForceKey::Gain, "gain", &[""]),
    (ForceKey::Value, "value", &[".x", ".y", ".z"]),
    (ForceKey::StiffnessMatrix, "stiffness_matrix", &[".1", ".2", ".3", ".4", ".5", ".6"]),
    (ForceKey::DampingMatrix, "damping_matrix", &[".1", ".2", ".3", ".4", ".5", ".6"]),
];

impl Parameter {
    /// Writes a value into the scene file; `modes` is the number of modes of each body.
    pub(crate) fn write(self, file: &mut SceneFile, modes: &[usize], value: f64) {
        let place = match self {
            Self::Gravity(k) => file.simulation.gravity.get_mut(k),
            Self::Step => file.simulation.step.as_mut(),
            Self::Tolerance => file.simulation.tolerance.as_mut(),
            Self::Body(body, key, k) => {
                let modes = modes.get(body).copied().unwrap_or(0);
                file.bodies.get_mut(body).and_then(|(_, table)| body_number(table, key, k, modes))
            }
            Self::Force(force, key, k) => file.forces.get_mut(force).and_then(|(_, table)| match key {
                ForceKey::Gain => Some(table.gain.get_or_insert(1.0)),
                _ => force_number(table, key, k),
            }),
        };
        if let Some(place) = place {
            *place = value;
        }
    }
}

fn body_number(table: &mut BodyTable, key: BodyKey, k: usize, modes: usize) -> Option<&mut f64> {
    match key {
        BodyKey::Position => table.position.get_mut(k),
        BodyKey::Orientation => table.orientation.get_or_insert(UPRIGHT).get_mut(k),
        BodyKey::Velocity => table.velocity.get_mut(k),
        BodyKey::AngularVelocity => table.angular_velocity.get_mut(k),
        BodyKey::ModalCoordinates => {
            table.modal_coordinates.get_or_insert_with(|| vec![0.0; modes]).get_mut(k)
        }
        BodyKey::ModalRates => table.modal_rates.get_or_insert_with(|| vec![0.0; modes]).get_mut(k),
    }
}

fn force_number(table: &mut ForceTable, key: ForceKey, k: usize) -> Option<&mut f64> {
    match key {
        ForceKey::Stiffness => table.stiffness.as_mut(),
        ForceKey::Damping => table.damping.as_mut(),
        ForceKey::Rest => table.rest.as_mut(),
        ForceKey::Limit => table.limit.as_mut(),
        ForceKey::Speed => table.speed.as_mut(),
        ForceKey::Coefficient => table.coefficient.as_mut(),
        ForceKey::Radius => table.radius.as_mut(),
        ForceKey::Gain => table.gain.as_mut(),
        ForceKey::Value => table.value.as_mut().and_then(|value| value.get_mut(k)),
        ForceKey::StiffnessMatrix => table.stiffness_matrix.as_mut().and_then(|six| six.get_mut(k)),
        ForceKey::DampingMatrix => table.damping_matrix.as_mut().and_then(|six| six.get_mut(k)),
    }
}
