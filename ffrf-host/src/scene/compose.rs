//! From a scene file to a mechanism in its initial state.

use std::path::Path;

use ffrf_codegen::body::significant;
use ffrf_runtime::State;
use ffrf_runtime::mechanism::{Assembly, Constrained};
use nalgebra::Vector3;

use super::consistency::residuals;
use super::efforts::{Composed, Joints};
use super::file::SceneFile;
use super::names::NamedBody;
use super::sensors::{Sensor, sensor};
use super::settings::{Coordinates, Integrator};
use super::{SceneError, SceneEvent, SceneModel, Settings, bodies, events, forces, joints};
use crate::mechanism::{Drive, HostMechanism, JointCoordinates, TreeError};
use crate::{HostBody, HostModal};

/// A scene that can be simulated.
pub struct Scene {
    /// The mechanism.
    pub mechanism: HostMechanism,
    /// Its state at time zero, as the file has it.
    pub initial: Vec<State<HostModal>>,
    /// What each flexible body was read from.
    pub models: Vec<Option<SceneModel>>,
    /// Names of the bodies.
    pub body_names: Vec<String>,
    /// Names of the markers of each body; joints and others have markers without a name after them.
    pub marker_names: Vec<Vec<String>>,
    /// Names of the connections: those of joints, and of their drives.
    pub connection_names: Vec<String>,
    /// Names of the force elements.
    pub element_names: Vec<String>,
    /// Names of the actuators.
    pub actuator_names: Vec<String>,
    /// For each body the file of its surface, if the scene names one: for pictures only.
    pub surfaces: Vec<Option<String>>,
    /// What is measured.
    pub sensors: Vec<Sensor>,
    /// What is waited for.
    pub events: Vec<SceneEvent>,
    /// How it is simulated.
    pub settings: Settings,
}

impl Scene {
    /// Reads a scene file and everything that it names. Errors: see [`SceneError`].
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        Self::compose(&SceneFile::read(path)?, folder)
    }

    /// Composes a scene; the files that it names are looked for in `folder`.
    ///
    /// Errors: see [`SceneError`], with the line of the key that is at fault.
    pub fn compose(file: &SceneFile, folder: &Path) -> Result<Self, SceneError> {
        Self::composed(file, folder).map_err(|error| error.on_line(&file.lines))
    }

    fn composed(file: &SceneFile, folder: &Path) -> Result<Self, SceneError> {
        let settings = Settings::new(&file.simulation)?;
        if file.bodies.is_empty() {
            return Err(SceneError::value("bodies", "at least one body", "none"));
        }
        let (mut named, mut states): (Vec<NamedBody>, Vec<State<HostModal>>) = (Vec::new(), Vec::new());
        for (name, table) in &file.bodies {
            check_name("bodies", name)?;
            let (body, state) = bodies::body(name, table, folder)?;
            named.push(body);
            states.push(state);
        }
        let mut connections: Vec<(_, Option<Drive>)> = Vec::new();
        let (mut connection_names, mut joint_connections) = (Vec::new(), Vec::new());
        for (name, table) in &file.joints {
            check_name("joints", name)?;
            let composed = joints::joint(name, table, &mut named, &states, folder)?;
            let mut own = vec![connections.len()];
            connections.push((composed.connection, None));
            connection_names.push(name.clone());
            if let Some((connection, drive)) = composed.drive {
                own.push(connections.len());
                connections.push((connection, Some(drive)));
                connection_names.push(format!("{name}.drive"));
            }
            joint_connections.push((name.clone(), own));
        }
        let (mut elements, mut actuators) = (Vec::new(), Vec::new());
        let (mut element_names, mut actuator_names, mut frictions) = (Vec::new(), Vec::new(), Vec::new());
        for (name, table) in &file.forces {
            check_name("forces", name)?;
            let joints = Joints { names: &joint_connections, connections: &connections };
            match forces::element(name, table, &mut named, &states, &joints, folder)? {
                Composed::Element(element) => {
                    elements.push(element);
                    element_names.push(name.clone());
                }
                Composed::Friction(friction) => frictions.push(friction),
                Composed::Actuator(actuator) => {
                    actuators.push(actuator);
                    actuator_names.push(name.clone());
                }
            }
        }
        let mut sensors = Vec::with_capacity(file.sensors.len());
        for (name, table) in &file.sensors {
            check_name("sensors", name)?;
            sensors.push(sensor(name, table, &mut named, &joint_connections)?);
        }
        let mut waited_for = Vec::with_capacity(file.events.len());
        for (name, table) in &file.events {
            check_name("events", name)?;
            waited_for.push(events::event(name, table, &sensors)?);
        }
        let surfaces = file.bodies.iter().map(|(_, table)| table.surface.clone()).collect();
        let body_names: Vec<String> = named.iter().map(|body| body.name.clone()).collect();
        let marker_names = named.iter().map(|body| body.marker_names.clone()).collect();
        let models = named.iter().map(|body| body.model.clone()).collect();
        let parts = named.into_iter().map(|body| (body.body, body.markers)).collect();
        let mechanism = HostMechanism::new(parts, connections, Vector3::from(file.simulation.gravity))?
            .with_elements(elements)
            .with_actuators(actuators)
            .with_frictions(frictions)
            .with_treatment(settings.treatment);
        let scene = Self {
            mechanism,
            initial: states,
            models,
            body_names,
            marker_names,
            connection_names,
            element_names,
            actuator_names,
            surfaces,
            sensors,
            events: waited_for,
            settings,
        };
        scene.joint_coordinates()?;
        scene.check_modes()?;
        Ok(scene)
    }

    /// The same with entries of invariants and of mode shapes at markers below `tolerance` times their Gram scale set to zero
    /// in its flexible bodies, see [`significant`].
    #[must_use]
    pub fn with_layout_tolerance(mut self, tolerance: f64) -> Self {
        for (index, model) in self.models.iter().enumerate() {
            if let Some(SceneModel { model, fidelity }) = model {
                let left = significant(model, tolerance, true);
                let body = HostBody::within(&left, fidelity, tolerance);
                self.mechanism.replace_body(index, body, HostBody::markers(&left));
            }
        }
        self
    }

    /// The coordinates of the joints, if they are what is integrated. Errors: the mechanism has none.
    pub fn joint_coordinates(&self) -> Result<Option<JointCoordinates<'_>>, SceneError> {
        if self.settings.coordinates == Coordinates::Absolute {
            return Ok(None);
        }
        let name = |joint: usize| self.connection_names.get(joint).map_or("", String::as_str);
        JointCoordinates::new(&self.mechanism).map(Some).map_err(|error| {
            let (expected, found) = match error {
                TreeError::Loop { joint } => {
                    ("a tree of bodies", format!("joint `{}`, which closes a loop", name(joint)))
                }
                TreeError::Unsupported { joint } => (
                    "fixed, revolute, prismatic, cylindrical, spherical and planar joints without drives",
                    format!("joint `{}`", name(joint)),
                ),
            };
            let expected = format!("{expected} with `constraints = \"minimal\"`");
            SceneError::value("simulation.constraints", expected, found)
        })
    }

    /// Whether the exponential step can be done. Errors: a joint holds what modes move, or a modal matrix is dense.
    fn check_modes(&self) -> Result<(), SceneError> {
        if self.settings.integrator != Integrator::Exponential {
            return Ok(());
        }
        let refused = |found: String| {
            let expected = "joints at points that modes do not move, and diagonal modal matrices, with \
                            `integrator = \"exponential\"`";
            Err(SceneError::value("simulation.integrator", expected, found))
        };
        if let Some(joint) = self.mechanism.joint_on_modes() {
            let name = self.connection_names.get(joint).map_or("", String::as_str);
            return refused(format!("joint `{name}`, which holds what modes move"));
        }
        if self.mechanism.modes(self.settings.output_step).is_none() {
            return refused("a dense modal mass, stiffness or damping".to_owned());
        }
        Ok(())
    }

    /// The initial state with the joints met, and how far the file's state was from them (position, velocity).
    ///
    /// Positions, then velocities, move as little as possible; parts are moved as a whole where that meets the joints.
    /// Errors: [`SceneError::NotAssembled`].
    pub fn assembled(&self) -> Result<(Vec<State<HostModal>>, [f64; 2]), SceneError> {
        self.assembled_at(0.0)
    }

    /// The same where drives are at `time` (s).
    pub fn assembled_at(&self, time: f64) -> Result<(Vec<State<HostModal>>, [f64; 2]), SceneError> {
        let system = Constrained(&self.mechanism);
        let not = |error: ffrf_runtime::StepError| match error {
            ffrf_runtime::StepError::ConstraintsNotMet { joint, residual } => SceneError::NotAssembled {
                joint: self.connection_names.get(joint).cloned().unwrap_or_default(),
                residual,
            },
            other => SceneError::Key { key: "bodies".to_owned(), message: other.to_string() },
        };
        let (state, drift) = system.assemble(time, self.initial.clone(), ASSEMBLED).map_err(not)?;
        self.check_rates(time, &state)?;
        Ok((state, [drift.position, drift.velocity]))
    }

    /// Whether velocities and accelerations of a state that is assembled at `time` (s) meet the joints, relative to what they are sums of.
    fn check_rates(&self, time: f64, state: &[State<HostModal>]) -> Result<(), SceneError> {
        let found = residuals(&self.mechanism, time, state).map_err(|error| SceneError::Key {
            key: "bodies".to_owned(),
            message: format!("the initial accelerations: {error}"),
        })?;
        for (level, unit, k, tolerance) in [
            ("velocities", "(m/s or rad/s)", 1, VELOCITY_MET),
            ("accelerations", "(m/s² or rad/s²)", 2, ACCELERATION_MET),
        ] {
            let mut worst = (0, 0.0_f64);
            for (joint, one) in found.iter().enumerate() {
                let share = one.left[k] / one.scale[k];
                // the first that is not a number stays the worst
                if share > worst.1 || (share.is_nan() && !worst.1.is_nan()) {
                    worst = (joint, share);
                }
            }
            let met = worst.1 <= tolerance;
            if !met {
                return Err(SceneError::Contradiction {
                    joint: self.connection_names.get(worst.0).cloned().unwrap_or_default(),
                    level,
                    residual: found.get(worst.0).map_or(f64::NAN, |one| one.left[k]),
                    unit,
                });
            }
        }
        Ok(())
    }
}

/// Velocities over the largest that they are sums of: what [`ASSEMBLED`] leaves of positions, and round-off.
const VELOCITY_MET: f64 = 1e-7;
/// The same of accelerations, which the regularisation of redundant rows and stiff modes leave less exact.
const ACCELERATION_MET: f64 = 1e-5;
/// Residual of an assembled mechanism. Units: m or rad.
const ASSEMBLED: f64 = 1e-8;

/// Names become heads of columns and parts of paths.
fn check_name(section: &str, name: &str) -> Result<(), SceneError> {
    let fine = !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '-');
    if fine && name != "ground" {
        return Ok(());
    }
    Err(SceneError::value(
        section,
        "names of letters, digits, `_` and `-`, other than `ground`",
        format!("`{}`", name.escape_debug()),
    ))
}
