//! An instance of an FMU: its life from instantiation to the end, without any of C.

use ffrf_host::scene::SceneError;
use ffrf_host::simulate::{CoSimulation, Point, SimulationError};
use thiserror::Error;

use crate::model::Model;
use crate::saved::Saved;
use crate::variables::{Role, Variable};

/// How far the life of an instance has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Phase {
    /// Parameters, inputs and the start can be set.
    Instantiated,
    /// The same, and what follows from them can be read.
    Initialisation,
    /// Steps can be done.
    Stepping,
    /// Values can be read.
    Terminated,
}

impl Phase {
    const ALL: [Self; 4] = [Self::Instantiated, Self::Initialisation, Self::Stepping, Self::Terminated];

    fn name(self) -> &'static str {
        match self {
            Self::Instantiated => "instantiated",
            Self::Initialisation => "in initialisation mode",
            Self::Stepping => "in step mode",
            Self::Terminated => "terminated",
        }
    }
}

/// One simulation of a model.
pub struct Instance {
    model: Model,
    phase: Phase,
    start: f64,
    /// Values of the parameters, in the order of the variables.
    parameters: Vec<f64>,
    /// Inputs that were set.
    inputs: Vec<Option<f64>>,
    /// There as soon as something is asked of it; always with the parameters and inputs above.
    simulation: Option<CoSimulation>,
}

/// Why something cannot be done.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum InstanceError {
    /// A function was called where the standard does not allow it.
    #[error("{call} is not allowed: the instance is {phase}, it must be {expected}")]
    Phase {
        /// What was called.
        call: &'static str,
        /// Where the instance is.
        phase: &'static str,
        /// Where it must be.
        expected: &'static str,
    },
    /// There is no variable with that value reference.
    #[error("value reference {reference}: expected one of 0 to {last}")]
    Reference {
        /// What was found.
        reference: u32,
        /// The largest that there is.
        last: usize,
    },
    /// A variable cannot be set, or not now.
    #[error("`{variable}` cannot be set: {why}")]
    Set {
        /// Its name.
        variable: String,
        /// Why.
        why: &'static str,
    },
    /// A value that no variable can have.
    #[error("`{variable}`: expected a finite number, found {value}")]
    NotFinite {
        /// Name of the variable.
        variable: String,
        /// What was found.
        value: f64,
    },
    /// The scene cannot be composed with the parameters that were set.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The simulation cannot begin or go on.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    /// A step that begins elsewhere, or does not go forwards.
    #[error("a step of {size:e} s from t = {from:e} s: expected a positive step from t = {time:e} s")]
    Step {
        /// Where it should begin. Units: s.
        from: f64,
        /// Its size. Units: s.
        size: f64,
        /// Where the instance is. Units: s.
        time: f64,
    },
    /// A start that is no number.
    #[error("start time: expected a finite number, found {0}")]
    Start(f64),
    /// A state of another model or of other sizes.
    #[error("the state is not one of this model")]
    State,
}

/// Where a step has led.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrival {
    /// Time. Units: s.
    pub time: f64,
    /// Whether an event of the scene ends the simulation here.
    pub stopped: bool,
    /// Events on the way, each as a line for people.
    pub events: Vec<String>,
}

/// How far a communication point may be from where the last step led, as a share of the step: other tools sum up steps.
const SAME_POINT: f64 = 1e-3;

impl Instance {
    /// An instance of a model.
    pub fn new(model: Model) -> Self {
        let (parameters, inputs) = (model.starts(), vec![None; model.actuators]);
        Self { model, phase: Phase::Instantiated, start: 0.0, parameters, inputs, simulation: None }
    }

    /// As it was at its beginning.
    pub fn reset(&mut self) {
        (self.parameters, self.inputs) = (self.model.starts(), vec![None; self.model.actuators]);
        (self.phase, self.start, self.simulation) = (Phase::Instantiated, 0.0, None);
    }

    /// Begins the initialisation of a simulation from `start` (s). Errors: see [`InstanceError`].
    pub fn enter_initialisation(&mut self, start: f64) -> Result<(), InstanceError> {
        self.must_be("the beginning of initialisation", &[Phase::Instantiated], "instantiated")?;
        if !start.is_finite() {
            return Err(InstanceError::Start(start));
        }
        if start != self.start {
            (self.start, self.simulation) = (start, None);
        }
        self.phase = Phase::Initialisation;
        Ok(())
    }

    /// Ends the initialisation: the joints are met, and steps can be done. Errors: see [`InstanceError`].
    pub fn exit_initialisation(&mut self) -> Result<(), InstanceError> {
        self.must_be("the end of initialisation", &[Phase::Initialisation], "in initialisation mode")?;
        self.simulation()?;
        self.phase = Phase::Stepping;
        Ok(())
    }

    /// Ends the simulation. Errors: see [`InstanceError`].
    pub fn terminate(&mut self) -> Result<(), InstanceError> {
        self.must_be("the end", &[Phase::Stepping], "in step mode")?;
        self.phase = Phase::Terminated;
        Ok(())
    }

    /// Advances by `size` from the communication point `from` (both s).
    ///
    /// Errors: see [`InstanceError`]; the instance is then where it was.
    pub fn step(&mut self, from: f64, size: f64) -> Result<Arrival, InstanceError> {
        self.must_be("a step", &[Phase::Stepping], "in step mode")?;
        let simulation = self.simulation()?;
        let time = simulation.point().time();
        let fits = size > 0.0 && size.is_finite() && (from - time).abs() <= SAME_POINT * size;
        if !fits {
            return Err(InstanceError::Step { from, size, time });
        }
        simulation.advance(from + size)?;
        let events = simulation.take_events().into_iter().map(|event| {
            let way = if event.rising { "rising" } else { "falling" };
            format!("event {}: t = {:.9e} s, {way}", event.name, event.time)
        });
        Ok(Arrival {
            events: events.collect(),
            time: simulation.point().time(),
            stopped: simulation.is_stopped(),
        })
    }

    /// The value of a variable. Errors: see [`InstanceError`].
    pub fn get(&mut self, reference: u32) -> Result<f64, InstanceError> {
        let role = self.variable(reference)?.role;
        match role {
            Role::Time => Ok(self.simulation.as_ref().map_or(self.start, |now| now.point().time())),
            Role::Parameter(..) => {
                let ordinal = self.ordinal(reference);
                self.parameters.get(ordinal).copied().ok_or(InstanceError::State)
            }
            Role::Input(actuator, start) => {
                let set = self.inputs.get(actuator).copied().flatten();
                let now = self.simulation.as_ref().and_then(|now| now.input(actuator));
                Ok(set.or(now).unwrap_or(start))
            }
            Role::Output(column) | Role::Local(column) => {
                let values = self.simulation()?.values()?;
                values.get(column).copied().ok_or(InstanceError::State)
            }
        }
    }

    /// Sets a variable. Errors: see [`InstanceError`].
    pub fn set(&mut self, reference: u32, value: f64) -> Result<(), InstanceError> {
        let Variable { role, name, .. } = self.variable(reference)?;
        let (role, variable) = (*role, name.clone());
        if !value.is_finite() {
            return Err(InstanceError::NotFinite { variable, value });
        }
        match role {
            Role::Parameter(..) if matches!(self.phase, Phase::Instantiated | Phase::Initialisation) => {
                let ordinal = self.ordinal(reference);
                let place = self.parameters.get_mut(ordinal).ok_or(InstanceError::State)?;
                if place.to_bits() != value.to_bits() {
                    *place = value;
                    self.simulation = None;
                }
                Ok(())
            }
            Role::Parameter(..) => Err(InstanceError::Set {
                variable,
                why: "parameters are fixed once the simulation has begun",
            }),
            Role::Input(actuator, _) => {
                if let Some(simulation) = &mut self.simulation {
                    simulation.set_input(actuator, value)?;
                }
                let place = self.inputs.get_mut(actuator).ok_or(InstanceError::State)?;
                *place = Some(value);
                Ok(())
            }
            _ => Err(InstanceError::Set { variable, why: "it is what the simulation computes" }),
        }
    }

    /// All that changes.
    pub fn save(&self) -> Saved {
        Saved {
            phase: Phase::ALL.iter().position(|phase| *phase == self.phase).unwrap_or(0) as f64,
            start: self.start,
            parameters: self.parameters.clone(),
            inputs: self.inputs.clone(),
            point: self.simulation.as_ref().map(|now| now.point().to_numbers()),
        }
    }

    /// Takes up a state again, bit by bit. Errors: see [`InstanceError`]; the instance is then where it was.
    pub fn resume(&mut self, saved: &Saved) -> Result<(), InstanceError> {
        let sizes = [saved.parameters.len(), saved.inputs.len()];
        let phase = Phase::ALL.iter().enumerate().find(|(number, _)| *number as f64 == saved.phase);
        let Some((_, phase)) = phase.filter(|_| sizes == [self.parameters.len(), self.inputs.len()]) else {
            return Err(InstanceError::State);
        };
        let bits = |list: &[f64]| list.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
        let same = bits(&saved.parameters) == bits(&self.parameters)
            && saved.start.to_bits() == self.start.to_bits();
        let simulation = match &saved.point {
            None => None,
            Some(numbers) => {
                let mut simulation = match self
                    .simulation
                    .take_if(|now| same && Point::from_numbers(now.scene(), numbers).is_some())
                {
                    Some(simulation) => simulation,
                    None => CoSimulation::new(self.model.scene(&saved.parameters)?, saved.start)?,
                };
                let point = Point::from_numbers(simulation.scene(), numbers).ok_or(InstanceError::State)?;
                simulation.resume(&point);
                Some(simulation)
            }
        };
        (self.phase, self.start, self.simulation) = (*phase, saved.start, simulation);
        (self.parameters, self.inputs) = (saved.parameters.clone(), saved.inputs.clone());
        Ok(())
    }

    /// A state from its bytes. Errors: they are not of this model.
    pub fn read_state(&self, bytes: &[u8]) -> Result<Saved, InstanceError> {
        let saved = Saved::from_bytes(bytes, &self.model.token, self.parameters.len(), self.inputs.len());
        saved.ok_or(InstanceError::State)
    }

    /// A state as bytes.
    pub fn write_state(&self, saved: &Saved) -> Vec<u8> {
        saved.to_bytes(&self.model.token)
    }

    /// The simulation, which begins when something is asked of it.
    fn simulation(&mut self) -> Result<&mut CoSimulation, InstanceError> {
        if self.simulation.is_none() {
            let mut new = CoSimulation::new(self.model.scene(&self.parameters)?, self.start)?;
            for (actuator, input) in self.inputs.iter().enumerate() {
                if let Some(input) = input {
                    new.set_input(actuator, *input)?;
                }
            }
            self.simulation = Some(new);
        }
        self.simulation.as_mut().ok_or(InstanceError::State)
    }

    fn must_be(
        &self,
        call: &'static str,
        phases: &[Phase],
        expected: &'static str,
    ) -> Result<(), InstanceError> {
        if phases.contains(&self.phase) {
            return Ok(());
        }
        Err(InstanceError::Phase { call, phase: self.phase.name(), expected })
    }

    fn variable(&self, reference: u32) -> Result<&Variable, InstanceError> {
        let found = self.model.variables.get(reference as usize);
        found
            .ok_or(InstanceError::Reference { reference, last: self.model.variables.len().saturating_sub(1) })
    }

    /// Parameters follow each other behind time.
    fn ordinal(&self, reference: u32) -> usize {
        (reference as usize).saturating_sub(1)
    }
}
