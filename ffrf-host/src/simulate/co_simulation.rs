//! A scene that is led from outside: from one communication point to the next, with inputs that are held between them.
//!
//! Without new inputs, the motion does not depend on where communication points are: whole steps follow each other as in
//! [`simulate`](super::simulate), and what lies between two of them is the end of a shorter step beside them. A new input
//! begins the steps anew where it is set.

use ffrf_runtime::{AlphaMemory, StepError};

use super::advance::{Reached, Step};
use super::one_step::States;
use super::run::reason;
use super::sample::sample;
use super::watch::{Passed, Watch};
use super::{Advance, Advancing, SimulationError};
use crate::mechanism::{Drive, HostIncrement};
use crate::scene::Scene;

/// A scene on its way.
pub struct CoSimulation {
    scene: Scene,
    /// What the actuators follow where nobody has set an input.
    schedules: Vec<Drive>,
    point: Point,
    /// The columns of [`header`](super::header) but the time, where they are known for the point.
    values: Option<Vec<f64>>,
    /// Events since they were last asked for.
    passed: Vec<Passed>,
}

/// All that changes on the way: what is taken up again from it goes on bit by bit.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// The last whole step.
    pub(super) advance: Advance,
    /// Time. Units: s.
    pub(super) time: f64,
    /// The state at this time.
    pub(super) state: States,
    /// What the generalised-α method remembers at this time.
    pub(super) memory: Option<AlphaMemory<HostIncrement>>,
    /// Angles that sensors have counted over turns. Units: rad.
    pub(super) angles: Vec<Option<f64>>,
    /// Inputs of actuators that were set.
    pub(super) inputs: Vec<Option<f64>>,
    /// What is left to the value of each event.
    pub(super) left: Vec<f64>,
    /// When it began. Units: s.
    pub(super) begin: f64,
    /// Whether an event has ended the run.
    pub(super) stopped: bool,
}

impl Point {
    /// Its time. Units: s.
    pub fn time(&self) -> f64 {
        self.time
    }
}

impl CoSimulation {
    /// Assembles a scene at `time` (s). Errors: see [`SimulationError`].
    pub fn new(scene: Scene, time: f64) -> Result<Self, SimulationError> {
        let (state, _) = scene.assembled_at(time)?;
        let advance = Advance::new(&scene.settings, time, state.clone());
        let watch = Watch::new(&scene, time, &state).map_err(|error| refused(&scene, (time, error)))?;
        let actuators = scene.mechanism.actuators();
        let point = Point {
            advance,
            time,
            state,
            memory: None,
            angles: vec![None; scene.sensors.len()],
            inputs: vec![None; actuators.len()],
            left: watch.before,
            begin: time,
            stopped: false,
        };
        let schedules = actuators.iter().map(|actuator| actuator.input.clone()).collect();
        let mut new = Self { scene, schedules, point, values: None, passed: Vec::new() };
        new.measure()?;
        Ok(new)
    }

    /// What is led.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Where it is.
    pub fn point(&self) -> &Point {
        &self.point
    }

    /// Whether an event has ended the run: it goes no further.
    pub fn is_stopped(&self) -> bool {
        self.point.stopped
    }

    /// Takes up a point of the same scene again. The numbers of bodies, modes, sensors and actuators must be its own, as
    /// they are in points of this type and in those read by [`Point::from_numbers`] for the same scene.
    pub fn resume(&mut self, point: &Point) {
        self.point = point.clone();
        self.values = None;
        self.passed.clear();
        for (actuator, (input, schedule)) in self.point.inputs.iter().zip(&self.schedules).enumerate() {
            let input = input.map_or_else(|| schedule.clone(), held);
            self.scene.mechanism.set_actuator_input(actuator, input);
        }
    }

    /// The input of an actuator now: what was set, or what the scene has at this time; none if there is no such actuator.
    pub fn input(&self, actuator: usize) -> Option<f64> {
        let schedule = self.schedules.get(actuator)?;
        Some(
            self.point
                .inputs
                .get(actuator)
                .copied()
                .flatten()
                .unwrap_or_else(|| schedule.at(self.point.time)[0]),
        )
    }

    /// Sets the input of an actuator from now on, in place of the function of time in the scene; it is held until it is set
    /// again. Nothing happens if there is no such actuator, or if the input has this value already.
    ///
    /// Errors: see [`SimulationError`].
    pub fn set_input(&mut self, actuator: usize, value: f64) -> Result<(), SimulationError> {
        let Some(now) = self.point.inputs.get(actuator) else { return Ok(()) };
        if now.is_some_and(|now| now.to_bits() == value.to_bits()) {
            return Ok(());
        }
        self.begin_anew()?;
        self.point.inputs[actuator] = Some(value);
        self.scene.mechanism.set_actuator_input(actuator, held(value));
        self.values = None;
        Ok(())
    }

    /// Advances to `end` (s), or to an event that ends the run before; nothing happens if that is not after the point.
    ///
    /// Errors: see [`SimulationError`]; the point is then where it was.
    pub fn advance(&mut self, end: f64) -> Result<(), SimulationError> {
        if self.point.stopped || end <= self.point.time {
            return Ok(());
        }
        let scene = &self.scene;
        let tree = scene.joint_coordinates()?;
        let advancing =
            Advancing { mechanism: &scene.mechanism, tree: tree.as_ref(), settings: &scene.settings };
        let mut advance = self.point.advance.clone();
        let mut watch = Watch::resumed(scene, self.point.left.clone(), self.point.begin);
        let mut look = |step: &Step<'_>| watch.look(step);
        let reached = advance.to(&advancing, end, &mut look).map_err(|error| refused(scene, error))?;
        let (left, passed) = (watch.before, watch.passed);
        (self.point.time, self.point.state, self.point.memory, self.point.stopped) = match reached {
            Reached::Sample(state, memory) => (end, state, memory, false),
            Reached::Stop(time, state) => (time, state, None, true),
        };
        (self.point.advance, self.point.left) = (advance, left);
        self.passed.extend(passed);
        self.values = None;
        self.measure()?;
        Ok(())
    }

    /// The columns of [`header`](super::header) but the time, at the point with its inputs.
    ///
    /// Errors: see [`SimulationError`].
    pub fn values(&mut self) -> Result<&[f64], SimulationError> {
        self.measure()?;
        Ok(self.values.as_deref().unwrap_or_default())
    }

    /// The events since this was last asked, in their order.
    pub fn take_events(&mut self) -> Vec<Passed> {
        std::mem::take(&mut self.passed)
    }

    /// Reads the sensors, and lets them count turns, if that has not been done at the point.
    fn measure(&mut self) -> Result<(), SimulationError> {
        if self.values.is_none() {
            let Point { time, state, angles, .. } = &mut self.point;
            let sample = sample(&self.scene, *time, state, angles);
            self.values = Some(sample.map_err(|error| refused(&self.scene, (*time, error)))?.values);
        }
        Ok(())
    }

    /// Lets whole steps begin at the point.
    fn begin_anew(&mut self) -> Result<(), SimulationError> {
        let (scene, point) = (&self.scene, &mut self.point);
        if point.stopped || point.advance.is_at(&scene.settings, point.time) {
            return Ok(());
        }
        let tree = scene.joint_coordinates()?;
        let advancing =
            Advancing { mechanism: &scene.mechanism, tree: tree.as_ref(), settings: &scene.settings };
        let mut watch = Watch::resumed(scene, point.left.clone(), point.begin);
        let stop = point
            .advance
            .look_at(&advancing, (point.time, &point.state), &mut |step| watch.look(step))
            .map_err(|error| refused(scene, error))?;
        point.left = watch.before;
        self.passed.extend(watch.passed);
        if let Some((time, state)) = stop {
            (point.time, point.state, point.stopped) = (time, state, true);
            self.values = None;
        }
        let (time, state, memory) = (point.time, point.state.clone(), point.memory.clone());
        point.advance = point.advance.restarted(&scene.settings, time, state, memory);
        Ok(())
    }
}

/// An input that stays what it is.
fn held(value: f64) -> Drive {
    Drive::Polynomial(vec![value])
}

fn refused(scene: &Scene, (time, error): (f64, StepError)) -> SimulationError {
    SimulationError::Step { time, reason: reason(scene, error) }
}
