//! The variables of an FMU: what other tools set and read.

use ffrf_host::scene::file::SceneFile;
use ffrf_host::scene::{Scene, SensorKind};
use ffrf_host::simulate::header;

use crate::parameter::{Parameter, parameters};

/// A variable: a number of double precision.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Its name; its place in the list is its value reference.
    pub name: String,
    /// Its unit as in the table of units; empty if it has none, or if that depends on the scene.
    pub unit: &'static str,
    /// A line for people.
    pub description: String,
    /// What it is.
    pub role: Role,
}

/// What a variable is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Role {
    /// Time.
    Time,
    /// A number of the scene file, to be set before the simulation begins.
    Parameter(Parameter, f64),
    /// The input of an actuator by its number, and its value as the scene begins.
    Input(usize, f64),
    /// A number of a sensor: a column of the samples.
    Output(usize),
    /// Another column of the samples.
    Local(usize),
}

/// The variables of a scene: time, parameters, inputs, then the columns of `ffrf simulate` in their order.
pub(crate) fn variables(file: &SceneFile, scene: &Scene) -> Vec<Variable> {
    let mut list = vec![Variable {
        name: "time".to_owned(),
        unit: "s",
        description: "simulated time".to_owned(),
        role: Role::Time,
    }];
    list.extend(parameters(file, scene).into_iter().map(|found| Variable {
        description: format!("key {} of the scene", found.name),
        name: found.name,
        unit: found.unit,
        role: Role::Parameter(found.parameter, found.start),
    }));
    for (number, (name, actuator)) in scene.actuator_names.iter().zip(scene.mechanism.actuators()).enumerate()
    {
        list.push(Variable {
            name: format!("{name}.input"),
            unit: "",
            description: format!(
                "input of the actuator `{name}`, held from one communication point to the next; until it is set, the actuator \
                 follows the function of time of the scene"
            ),
            role: Role::Input(number, actuator.input.at(0.0)[0]),
        });
    }
    list.extend(columns(scene));
    list
}

/// The columns of the samples.
fn columns(scene: &Scene) -> Vec<Variable> {
    let names = header(scene).into_iter().skip(1);
    let bodies: usize = scene.mechanism.bodies().iter().map(|body| 13 + 2 * body.mode_count()).sum();
    let sensors = scene.sensors.iter().flat_map(|sensor| {
        let count = sensor.kind.columns().len();
        std::iter::repeat_n((&sensor.name, measured(&sensor.kind)), count)
    });
    let mut sensors = sensors.collect::<Vec<_>>().into_iter();
    let variables = names.enumerate().map(|(column, name)| {
        let sensor = if column < bodies { None } else { sensors.next() };
        let (role, unit, description) = match sensor {
            Some((sensor, (unit, what))) => {
                (Role::Output(column), unit, format!("sensor `{sensor}`: {what}"))
            }
            None => {
                let (unit, what) = of_state(&name);
                (Role::Local(column), unit, what.to_owned())
            }
        };
        Variable { name, unit, description, role }
    });
    variables.collect()
}

/// Unit and meaning of what a sensor measures.
fn measured(kind: &SensorKind) -> (&'static str, &'static str) {
    match kind {
        SensorKind::Position(_) => ("m", "position, inertial"),
        SensorKind::Velocity(_) => ("m/s", "velocity, inertial"),
        SensorKind::Acceleration(_) => ("m/s2", "acceleration, inertial"),
        SensorKind::Orientation(_) => ("", "Euler parameters, scalar first"),
        SensorKind::Angle(_) => ("rad", "angle of the joint, counted over turns"),
        SensorKind::ReactionForce(_) => ("N", "force of the joint on its second body, inertial"),
        SensorKind::ReactionMoment(_) => {
            ("N.m", "moment of the joint on its second body about the attachment, inertial")
        }
        SensorKind::SectionForce { .. } => ("", "force (N) or moment (N m) through the section, body frame"),
        SensorKind::Stress { .. } => ("Pa", "stress, body frame, or von Mises' equivalent"),
    }
}

/// Unit and meaning of a column that no sensor has.
fn of_state(name: &str) -> (&'static str, &'static str) {
    let mut parts = name.rsplit('.');
    let (last, what) = (parts.next().unwrap_or(""), parts.next().unwrap_or(""));
    match (what, last) {
        ("energy", _) => ("J", "energy"),
        ("drift", _) => ("", "largest residual of the joints, m or rad, or that per second"),
        ("position", _) => ("m", "of the frame origin, inertial"),
        ("orientation", _) => ("", "Euler parameters, body to inertial"),
        ("velocity", _) => ("m/s", "of the frame origin, inertial"),
        ("angular_velocity", _) => ("rad/s", "in the body frame"),
        ("modal_coordinates", _) => ("", "modal coordinate"),
        _ => ("", "modal rate"),
    }
}
