//! The quantities in which errors are taken.

use std::fmt;
use std::str::FromStr;

use super::TradeoffError;
use crate::scene::{Scene, Sensor, SensorKind};

/// What a user asks for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Quantity {
    /// The sensor of that name.
    Sensor(String),
    /// Forces and moments of all joints.
    Reaction,
    /// Kinetic, elastic and potential energy together.
    Energy,
}

impl FromStr for Quantity {
    type Err = String;

    /// `reaction`, `energy`, or `sensor NAME`; a name alone is a sensor.
    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "" => Err("expected a sensor, `reaction` or `energy`".to_owned()),
            "reaction" => Ok(Self::Reaction),
            "energy" => Ok(Self::Energy),
            other => Ok(Self::Sensor(other.strip_prefix("sensor ").unwrap_or(other).trim().to_owned())),
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sensor(name) => write!(formatter, "sensor {name}"),
            Self::Reaction => formatter.write_str("reaction"),
            Self::Energy => formatter.write_str("energy"),
        }
    }
}

/// One vector over time whose error is taken.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: &'static str,
    pub(super) source: Source,
}

/// Where its numbers come from.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Source {
    Sensor(SensorKind),
    /// Position of the frame of a body.
    Place(usize),
    /// Orientation of the frame of a body.
    Orientation(usize),
    Energy,
    /// Every number of the state of a body, and its modes.
    State(usize, usize),
}

impl Channel {
    /// The whole states of a scene, for those who look at the motion and not at errors.
    pub(super) fn states(scene: &Scene) -> Vec<Self> {
        let bodies = scene.body_names.iter().zip(scene.mechanism.bodies()).enumerate();
        let one = |(index, (name, body)): (usize, (&String, &crate::HostBody))| Self {
            name: name.clone(),
            unit: "",
            source: Source::State(index, body.mode_count()),
        };
        bodies.map(one).collect()
    }

    /// The channels that the quantities name; without any, every sensor, or the frames of all bodies if there is none.
    ///
    /// Errors: [`TradeoffError::Quantity`].
    pub fn of(scene: &Scene, quantities: &[Quantity]) -> Result<Vec<Self>, TradeoffError> {
        if quantities.is_empty() {
            let sensors: Vec<Self> = scene.sensors.iter().map(Self::sensor).collect();
            return Ok(if sensors.is_empty() { frames(scene) } else { sensors });
        }
        let mut channels = Vec::new();
        for quantity in quantities {
            match quantity {
                Quantity::Energy => {
                    channels.push(Self { name: "energy".to_owned(), unit: "J", source: Source::Energy })
                }
                Quantity::Reaction => channels.extend(reactions(scene)),
                Quantity::Sensor(name) => {
                    let found = scene.sensors.iter().find(|sensor| sensor.name == *name);
                    channels.push(found.map(Self::sensor).ok_or_else(|| unknown(scene, name))?);
                }
            }
        }
        if channels.is_empty() {
            return Err(unknown(scene, "reaction"));
        }
        Ok(channels)
    }

    fn sensor(sensor: &Sensor) -> Self {
        let unit = match &sensor.kind {
            SensorKind::Position(_) => "m",
            SensorKind::Velocity(_) => "m/s",
            SensorKind::Acceleration(_) => "m/s²",
            SensorKind::Orientation(_) => "1",
            SensorKind::Angle(_) => "rad",
            SensorKind::ReactionForce(_) => "N",
            SensorKind::ReactionMoment(_) => "N m",
            SensorKind::Stress { .. } => "N/m²",
            SensorKind::SectionForce { .. } => "N, N m",
        };
        Self { name: sensor.name.clone(), unit, source: Source::Sensor(sensor.kind.clone()) }
    }

    /// How many numbers it has.
    pub(super) fn width(&self) -> usize {
        match &self.source {
            Source::Sensor(kind) => kind.columns().len(),
            Source::Place(_) => 3,
            Source::Orientation(_) => 4,
            Source::Energy => 1,
            Source::State(_, modes) => 13 + 2 * modes,
        }
    }

    /// Whether it is a quaternion, which says the same with the other sign.
    pub(super) fn is_orientation(&self) -> bool {
        matches!(self.source, Source::Orientation(_) | Source::Sensor(SensorKind::Orientation(_)))
    }

    /// Whether its size is how far it goes, not how far from zero it is: the origin of places is a choice.
    pub(super) fn is_place(&self) -> bool {
        matches!(
            self.source,
            Source::Place(_) | Source::Sensor(SensorKind::Position(_) | SensorKind::Angle(_))
        )
    }
}

fn unknown(scene: &Scene, found: &str) -> TradeoffError {
    let mut known: Vec<String> = scene.sensors.iter().map(|sensor| format!("`{}`", sensor.name)).collect();
    if !scene.connection_names.is_empty() {
        known.push("`reaction`".to_owned());
    }
    known.push("`energy`".to_owned());
    TradeoffError::Quantity { found: found.to_owned(), known: known.join(", ") }
}

fn frames(scene: &Scene) -> Vec<Channel> {
    let one = |(body, name): (usize, &String)| {
        [
            Channel { name: format!("{name}.position"), unit: "m", source: Source::Place(body) },
            Channel { name: format!("{name}.orientation"), unit: "1", source: Source::Orientation(body) },
        ]
    };
    scene.body_names.iter().enumerate().flat_map(one).collect()
}

/// Force and moment of every joint, with its drive.
fn reactions(scene: &Scene) -> Vec<Channel> {
    let mut joints: Vec<(&str, Vec<usize>)> = Vec::new();
    for (index, name) in scene.connection_names.iter().enumerate() {
        let name = name.strip_suffix(".drive").unwrap_or(name);
        match joints.iter_mut().find(|(known, _)| *known == name) {
            Some((_, connections)) => connections.push(index),
            None => joints.push((name, vec![index])),
        }
    }
    let both = |(name, connections): (&str, Vec<usize>)| {
        let force = Source::Sensor(SensorKind::ReactionForce(connections.clone()));
        let moment = Source::Sensor(SensorKind::ReactionMoment(connections));
        [
            Channel { name: format!("{name}.force"), unit: "N", source: force },
            Channel { name: format!("{name}.moment"), unit: "N m", source: moment },
        ]
    };
    joints.into_iter().flat_map(both).collect()
}
