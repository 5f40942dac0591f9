//! The state of a scene in a file: written and read without the loss of a bit.

use std::collections::BTreeMap;

use ffrf_runtime::{AlphaMemory, Increment, State};
use nalgebra::{DVector, Quaternion, UnitQuaternion};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::Advance;
use crate::HostModal;
use crate::mechanism::HostIncrement;
use crate::scene::{Scene, StepChoice};

/// The state of all bodies at one time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SavedState {
    /// Time. Units: s.
    pub time: f64,
    /// What an error-controlled integrator tries next. Units: s.
    pub next_step: f64,
    /// Angles that sensors have counted over turns. Units: rad.
    pub angles: Vec<Option<f64>>,
    /// Bodies by name.
    pub bodies: BTreeMap<String, BodyState>,
    /// Where the last whole step ended, if that was before `time`: from there a run goes on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub whole_step: Option<WholeStep>,
}

/// The end of a whole step; times between are reached by shorter steps beside them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WholeStep {
    /// Time. Units: s.
    pub time: f64,
    /// Bodies by name.
    pub bodies: BTreeMap<String, BodyState>,
}

/// The state of one body; frames and units as in scene files.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodyState {
    /// Position of the frame origin. Units: m. Frame: inertial.
    pub position: [f64; 3],
    /// Orientation, scalar first.
    pub orientation: [f64; 4],
    /// Modal coordinates.
    pub modal_coordinates: Vec<f64>,
    /// Velocity of the frame origin. Units: m/s. Frame: inertial.
    pub velocity: [f64; 3],
    /// Angular velocity. Units: rad/s. Frame: body.
    pub angular_velocity: [f64; 3],
    /// Modal rates.
    pub modal_rates: Vec<f64>,
    /// What the generalised-α method remembers: accelerations and its shifted ones, each linear (3), angular (3), modal.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub remembered_accelerations: Vec<f64>,
}

/// Why a saved state does not fit a scene.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum StateError {
    /// A body of the scene is missing, or has another number of modes.
    #[error("body `{body}`: expected {expected} modal coordinates and rates, found {found}")]
    Modes {
        /// The body.
        body: String,
        /// Number of modes in the scene.
        expected: usize,
        /// What the file has.
        found: String,
    },
    /// A body that the scene does not have.
    #[error("body `{body}` is not in the scene")]
    Extra {
        /// The body.
        body: String,
    },
}

impl SavedState {
    pub(crate) fn new(
        scene: &Scene,
        time: f64,
        advance: &Advance,
        angles: &[Option<f64>],
        state: &[State<HostModal>],
    ) -> Self {
        let memory = advance.memory.as_ref();
        let whole = !advance.is_at(&scene.settings, time);
        let whole_step =
            whole.then(|| WholeStep { time: advance.time, bodies: saved(scene, &advance.state, memory) });
        let memory = memory.filter(|_| !whole);
        let bodies = saved(scene, state, memory);
        Self { time, next_step: advance.next_step, angles: angles.to_vec(), bodies, whole_step }
    }

    /// From where the run goes on. Errors: see [`StateError`].
    pub(super) fn advance(&self, scene: &Scene) -> Result<Advance, StateError> {
        let (time, bodies) = match &self.whole_step {
            Some(WholeStep { time, bodies }) => (*time, bodies),
            None => (self.time, &self.bodies),
        };
        let mut advance = Advance::new(&scene.settings, time, restored(scene, bodies)?);
        if matches!(scene.settings.step, StepChoice::Tolerance(_)) {
            advance.next_step = self.next_step;
        }
        advance.memory = memory(scene, bodies)?;
        Ok(advance)
    }

    /// The states of the bodies of a scene, bit by bit. Errors: see [`StateError`].
    pub fn states(&self, scene: &Scene) -> Result<Vec<State<HostModal>>, StateError> {
        restored(scene, &self.bodies)
    }
}

/// The states of all bodies by name.
fn saved(
    scene: &Scene,
    states: &[State<HostModal>],
    memory: Option<&AlphaMemory<HostIncrement>>,
) -> BTreeMap<String, BodyState> {
    let bodies = scene.body_names.iter().zip(states).enumerate().map(|(index, (name, state))| {
        let theta = &state.orientation;
        let remembered = memory.into_iter().flat_map(|memory| [&memory.accelerations, &memory.shifted]);
        let body = BodyState {
            position: state.position.into(),
            orientation: [theta.w, theta.i, theta.j, theta.k],
            modal_coordinates: state.modal_coordinates.0.as_slice().to_vec(),
            velocity: state.velocity.into(),
            angular_velocity: state.angular_velocity.into(),
            modal_rates: state.modal_rates.0.as_slice().to_vec(),
            remembered_accelerations: remembered.flat_map(|all| flat(&all.0[index])).collect(),
        };
        (name.clone(), body)
    });
    bodies.collect()
}

/// What the generalised-α method remembered, if every body has it.
fn memory(
    scene: &Scene,
    saved: &BTreeMap<String, BodyState>,
) -> Result<Option<AlphaMemory<HostIncrement>>, StateError> {
    if saved.values().all(|body| body.remembered_accelerations.is_empty()) {
        return Ok(None);
    }
    let none = HostIncrement(Vec::new());
    let mut memory = AlphaMemory { accelerations: none.clone(), shifted: none };
    for (name, body) in scene.body_names.iter().zip(scene.mechanism.bodies()) {
        let modes = body.mode_count();
        let numbers = saved.get(name).map_or(&[][..], |body| &body.remembered_accelerations);
        if numbers.len() != 2 * (6 + modes) {
            let found = format!("{} remembered accelerations", numbers.len());
            return Err(StateError::Modes { body: name.clone(), expected: modes, found });
        }
        let (accelerations, shifted) = numbers.split_at(6 + modes);
        memory.accelerations.0.push(raised(accelerations));
        memory.shifted.0.push(raised(shifted));
    }
    Ok(Some(memory))
}

/// The states of the bodies of a scene, bit by bit.
fn restored(scene: &Scene, saved: &BTreeMap<String, BodyState>) -> Result<Vec<State<HostModal>>, StateError> {
    if let Some(body) = saved.keys().find(|name| !scene.body_names.contains(name)) {
        return Err(StateError::Extra { body: body.clone() });
    }
    let bodies = scene.body_names.iter().zip(scene.mechanism.bodies());
    bodies
        .map(|(name, body)| {
            let expected = body.mode_count();
            let refused = |found: String| StateError::Modes { body: name.clone(), expected, found };
            let saved = saved.get(name).ok_or_else(|| refused("no such body".to_owned()))?;
            if saved.modal_coordinates.len() != expected || saved.modal_rates.len() != expected {
                let counts = [saved.modal_coordinates.len(), saved.modal_rates.len()];
                return Err(refused(format!("{} and {}", counts[0], counts[1])));
            }
            let [w, i, j, k] = saved.orientation;
            Ok(State {
                position: saved.position.into(),
                // not normalised: it was when it was saved, and must keep its bits
                orientation: UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, k)),
                modal_coordinates: HostModal(DVector::from_column_slice(&saved.modal_coordinates)),
                velocity: saved.velocity.into(),
                angular_velocity: saved.angular_velocity.into(),
                modal_rates: HostModal(DVector::from_column_slice(&saved.modal_rates)),
            })
        })
        .collect()
}

/// The rates of velocities of an increment: linear, angular, modal.
fn flat(rates: &Increment<HostModal>) -> Vec<f64> {
    let rigid = rates.velocity.iter().chain(rates.angular_velocity.iter());
    rigid.chain(rates.modal_rates.0.as_slice()).copied().collect()
}

/// The increment of rates of velocities, six and those of the modes.
fn raised(numbers: &[f64]) -> Increment<HostModal> {
    let (rigid, modal) = numbers.split_at(6);
    let modal = HostModal(DVector::from_column_slice(modal));
    let mut rates = Increment::zeros(&modal);
    rates.velocity.copy_from_slice(&rigid[..3]);
    rates.angular_velocity.copy_from_slice(&rigid[3..]);
    rates.modal_rates = modal;
    rates
}
