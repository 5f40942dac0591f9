//! The scene file as it is written: tables and keys.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use serde::de::IntoDeserializer;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::SceneError;
use super::lines::{Lines, line_at};
use super::modes_value::ModesValue;

/// Three numbers.
pub type Vector = [f64; 3];

/// `[simulation]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SimulationTable {
    /// Simulated time. Units: s.
    pub duration: f64,
    /// Fixed step. Units: s.
    pub step: Option<f64>,
    /// Relative tolerance of an error-controlled integrator, in place of a step.
    pub tolerance: Option<f64>,
    /// Name of the integrator; `rk4` if nothing is said, `dopri5` with a tolerance.
    pub integrator: Option<String>,
    /// ρ∞ of the generalised-α method.
    pub rho_infinity: Option<f64>,
    /// Treatment of the constraints; what goes best with the integrator if nothing is said.
    pub constraints: Option<String>,
    /// Gravity. Units: m/s². Frame: inertial.
    #[serde(default)]
    pub gravity: Vector,
    /// Time between samples of the output. Units: s.
    pub output_step: Option<f64>,
}

/// `[bodies.NAME]`: flexible with `model`, rigid with `mass`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodyTable {
    /// Model file, relative to the scene file.
    pub model: Option<String>,
    /// Surface file for animations, relative to the scene file; no number of a simulation depends on it.
    pub surface: Option<String>,
    /// Which modes are used; all if nothing is said.
    pub modes: Option<ModesValue>,
    /// Which terms of the kinetic energy are kept: a level, or a list of terms.
    pub fidelity: Option<FidelityValue>,
    /// Mass of a rigid body. Units: kg.
    pub mass: Option<f64>,
    /// Its centre of mass. Units: m. Frame: body.
    pub center_of_mass: Option<Vector>,
    /// Its inertia tensor about the centre of mass. Units: kg m². Frame: body.
    pub inertia: Option<[Vector; 3]>,
    /// Markers of a rigid body by name. Units: m. Frame: body.
    #[serde(default)]
    pub markers: BTreeMap<String, Vector>,
    /// Position of the frame origin. Units: m. Frame: inertial.
    #[serde(default)]
    pub position: Vector,
    /// Orientation, scalar first; body to inertial.
    pub orientation: Option<[f64; 4]>,
    /// Velocity of the frame origin. Units: m/s. Frame: inertial.
    #[serde(default)]
    pub velocity: Vector,
    /// Angular velocity. Units: rad/s. Frame: body.
    #[serde(default)]
    pub angular_velocity: Vector,
    /// Modal coordinates.
    pub modal_coordinates: Option<Vec<f64>>,
    /// Modal rates.
    pub modal_rates: Option<Vec<f64>>,
}

/// A fidelity by its name or as a list of energy terms.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum FidelityValue {
    /// `full`, `linear`, `constant`, `rigid`.
    Level(String),
    /// Names of energy terms.
    Terms(Vec<String>),
}

/// `[joints.NAME]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct JointTable {
    /// What kind of joint.
    pub kind: String,
    /// `ground`, BODY or BODY.MARKER.
    pub first: String,
    /// Position of the attachment in the frame of `first`. Units: m.
    pub first_position: Option<Vector>,
    /// `ground`, BODY or BODY.MARKER.
    pub second: String,
    /// Position of the attachment in the frame of `second`. Units: m.
    pub second_position: Option<Vector>,
    /// Axis in the frame of `first`; z if nothing is said.
    pub axis: Option<Vector>,
    /// Second axis of a universal joint, in the frame of `second`.
    pub second_axis: Option<Vector>,
    /// Length of a distance joint; the initial distance if nothing is said. Units: m.
    pub length: Option<f64>,
    /// Translations that a generic joint holds, along x, y and z of the joint's triad (z is the axis).
    pub translation: Option<[bool; 3]>,
    /// Rotations that a generic joint holds.
    pub rotation: Option<[bool; 3]>,
    /// A motion that is given.
    pub drive: Option<DriveTable>,
}

/// `drive = { angle = ... }` or `drive = { position = ... }`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DriveTable {
    /// Angle about the axis. Units: rad.
    pub angle: Option<FunctionValue>,
    /// Travel along the axis. Units: m.
    pub position: Option<FunctionValue>,
}

/// A function of time.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum FunctionValue {
    /// Coefficients of a polynomial, the constant first.
    Polynomial(Vec<f64>),
    /// A formula in t, or the name of a table file.
    Text(String),
}

/// `[forces.NAME]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ForceTable {
    /// `spring`, `torsion_spring`, `bushing`, `friction`, `actuator`, `force`, `moment`.
    pub kind: String,
    /// The joint in which friction or an actuator acts, in place of `first`, `second` and `axis`.
    pub joint: Option<String>,
    /// `ground`, BODY or BODY.MARKER; where the force element begins.
    pub first: Option<String>,
    /// Position in the frame of `first`. Units: m.
    pub first_position: Option<Vector>,
    /// `ground`, BODY or BODY.MARKER; where the force acts.
    pub second: Option<String>,
    /// Position in the frame of `second`. Units: m.
    pub second_position: Option<Vector>,
    /// Axis of a torsion spring, of friction and actuators, in the frame of `first`.
    pub axis: Option<Vector>,
    /// Where friction or an actuator acts: `about` or `along` the axis, or on the `line` between both ends.
    pub acts: Option<String>,
    /// The largest force or moment of friction or an actuator. Units: N or N m.
    pub limit: Option<f64>,
    /// Speed at which friction has 71 % of its limit. Units: m/s or rad/s.
    pub speed: Option<f64>,
    /// Coefficient of friction that follows the reaction of its joint.
    pub coefficient: Option<f64>,
    /// Radius of the bearing, for friction about an axis that follows the reaction. Units: m.
    pub radius: Option<f64>,
    /// Input of an actuator over time.
    pub input: Option<FunctionValue>,
    /// Force or moment of an actuator per unit of its input. Units: N or N m.
    pub gain: Option<f64>,
    /// Stiffness. Units: N/m or N m/rad.
    pub stiffness: Option<f64>,
    /// Damping, the viscous part of friction. Units: N s/m or N m s/rad.
    pub damping: Option<f64>,
    /// Length (m) or angle (rad) without force; the initial one if nothing is said.
    pub rest: Option<f64>,
    /// Stiffness of a bushing along and about x, y, z of `first`. Units: N/m and N m/rad.
    pub stiffness_matrix: Option<[f64; 6]>,
    /// Damping of a bushing along and about x, y, z of `first`.
    pub damping_matrix: Option<[f64; 6]>,
    /// A constant force (N) or moment (N m).
    pub value: Option<Vector>,
    /// The frame of `value`: `inertial` (if nothing is said) or `body`.
    pub frame: Option<String>,
}

/// `[sensors.NAME]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SensorTable {
    /// What is measured.
    pub kind: String,
    /// BODY, BODY.MARKER or a joint.
    pub of: String,
}

/// `[events.NAME]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EventTable {
    /// The sensor that is watched.
    pub sensor: String,
    /// Which of its numbers: `x`, `y`, `z`, `w`; none where it has one.
    pub component: Option<String>,
    /// The value that is passed; zero if nothing is said. Units: those of the sensor.
    #[serde(default)]
    pub value: f64,
    /// `either` (if nothing is said), `rising` or `falling`.
    pub direction: Option<String>,
    /// `record` (if nothing is said) or `stop`.
    pub then: Option<String>,
}

/// A scene file, in its order.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneFile {
    /// `[simulation]`
    pub simulation: SimulationTable,
    /// `[bodies.*]`
    pub bodies: Vec<(String, BodyTable)>,
    /// `[joints.*]`
    pub joints: Vec<(String, JointTable)>,
    /// `[forces.*]`
    pub forces: Vec<(String, ForceTable)>,
    /// `[sensors.*]`
    pub sensors: Vec<(String, SensorTable)>,
    /// `[events.*]`
    pub events: Vec<(String, EventTable)>,
    /// Lines of all keys.
    pub lines: Lines,
}

impl SceneFile {
    /// Reads a scene file. Errors: [`SceneError::Read`], [`SceneError::Syntax`], [`SceneError::Key`].
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        let text = std::fs::read_to_string(path)
            .map_err(|source| SceneError::Read { path: path.to_owned(), source })?;
        Self::parse(&text)
    }

    /// Reads the text of a scene file.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        let mut table = DeTable::parse(text).map_err(Box::new)?.into_inner();
        let lines = Lines::of(text, &table);
        let file = Reading { text };
        let simulation = table.remove("simulation").ok_or_else(|| SceneError::Key {
            key: "simulation".to_owned(),
            message: "the table [simulation] is missing".to_owned(),
        })?;
        let scene = Self {
            simulation: file.value("simulation", simulation)?,
            bodies: file.tables("bodies", &mut table)?,
            joints: file.tables("joints", &mut table)?,
            forces: file.tables("forces", &mut table)?,
            sensors: file.tables("sensors", &mut table)?,
            events: file.tables("events", &mut table)?,
            lines,
        };
        match table.keys().next() {
            Some(unknown) => Err(file.at(
                unknown.span().start,
                SceneError::Key {
                    key: unknown.get_ref().escape_debug().to_string(),
                    message: "unknown table, expected one of `simulation`, `bodies`, `joints`, `forces`, `sensors`, `events`"
                        .to_owned(),
                },
            )),
            None => Ok(scene),
        }
    }
}

/// The text that is read, for the lines of what is wrong.
struct Reading<'a> {
    text: &'a str,
}

impl Reading<'_> {
    /// The tables `[section.*]` in their order.
    fn tables<T: for<'a> Deserialize<'a>>(
        &self,
        section: &str,
        table: &mut DeTable<'_>,
    ) -> Result<Vec<(String, T)>, SceneError> {
        let Some(found) = table.remove(section) else { return Ok(Vec::new()) };
        let place = found.span().start;
        match found.into_inner() {
            DeValue::Table(found) => found
                .into_iter()
                .map(|(name, entry)| {
                    let name = name.into_inner().into_owned();
                    let value = self.value(&format!("{section}.{name}"), entry)?;
                    Ok((name, value))
                })
                .collect(),
            other => {
                let message = format!("expected tables [{section}.NAME], found {}", other.type_str());
                Err(self.at(place, SceneError::Key { key: section.to_owned(), message }))
            }
        }
    }

    fn value<T: for<'a> Deserialize<'a>>(
        &self,
        key: &str,
        found: Spanned<DeValue<'_>>,
    ) -> Result<T, SceneError> {
        let begin = found.span().start;
        T::deserialize(found.into_deserializer()).map_err(|error| {
            let place = error.span().map_or(begin, |span| span.start);
            self.at(place, SceneError::Key { key: key.to_owned(), message: error.message().to_owned() })
        })
    }

    fn at(&self, place: usize, error: SceneError) -> SceneError {
        SceneError::Line { line: line_at(self.text, place), error: Box::new(error) }
    }
}
