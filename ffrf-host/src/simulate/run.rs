//! The way of a scene through time.

use ffrf_runtime::StepError;
use ffrf_runtime::mechanism::Assembly;
use thiserror::Error;

use super::advance::{Reached, Step};
use super::sample::sample;
use super::spin::SpinWatch;
use super::watch::{Passed, Watch};
use super::{Advance, Advancing, Sample, SavedState, SpinWarning, StateError};
use crate::scene::{Scene, SceneError};

/// Where a simulation is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Time. Units: s.
    pub time: f64,
    /// Share of the duration that is done.
    pub share: f64,
    /// Steps so far.
    pub steps: u64,
}

/// What a simulation says at its end.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Steps, refused tries and the largest drift.
    pub advance: Advance,
    /// How far the file's state was from the joints: position (m or rad), velocity.
    pub initial_residuals: [f64; 2],
    /// The state at the end.
    pub end: SavedState,
    /// Bodies that turned faster than their modes can stand.
    pub spin: Vec<SpinWarning>,
    /// Events that happened, in their order.
    pub events: Vec<Passed>,
}

/// Why a simulation ended early.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SimulationError {
    /// The scene cannot be assembled.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A saved state does not fit.
    #[error("saved state: {0}")]
    State(#[from] StateError),
    /// A step was refused.
    #[error("t = {time:.9e} s: {reason}")]
    Step {
        /// Time of the step. Units: s.
        time: f64,
        /// Why, with the name of a joint in place of its number.
        reason: String,
    },
    /// A sample could not be written.
    #[error(transparent)]
    Output(#[from] std::io::Error),
}

/// Simulates a scene from its initial or a saved state and hands each sample to `write`.
///
/// Errors: see [`SimulationError`]; samples up to there have been written.
pub fn simulate(
    scene: &Scene,
    from: Option<&SavedState>,
    mut write: impl FnMut(&Sample) -> std::io::Result<()>,
    mut progress: impl FnMut(Progress),
) -> Result<Summary, SimulationError> {
    let settings = &scene.settings;
    let tree = scene.joint_coordinates()?;
    let advancing = Advancing { mechanism: &scene.mechanism, tree: tree.as_ref(), settings };
    let mut angles = vec![None; scene.sensors.len()];
    let (mut time, mut state, mut advance, initial_residuals) = match from {
        None => {
            let (state, residuals) = scene.assembled()?;
            (0.0, state.clone(), Advance::new(settings, 0.0, state), residuals)
        }
        Some(saved) => {
            if saved.angles.len() == angles.len() {
                angles.clone_from(&saved.angles);
            }
            (saved.time, saved.states(scene)?, saved.advance(scene)?, [0.0; 2])
        }
    };
    let refused = |time: f64, error: StepError| SimulationError::Step { time, reason: reason(scene, error) };
    let mut events = Watch::new(scene, time, &state).map_err(|error| refused(time, error))?;
    let mut watch = SpinWatch::new(scene);
    watch.look(scene, time, &state);
    write(&sample(scene, time, &state, &mut angles).map_err(|error| refused(time, error))?)?;
    // samples stand on a grid that begins at zero, so that a run continued is the run itself
    let mut index = (time / settings.output_step * (1.0 + 1e-12)).floor() + 1.0;
    while time < settings.duration {
        let mut end = index * settings.output_step;
        if end > settings.duration * (1.0 - 1e-12) {
            end = settings.duration;
        }
        if end <= time {
            index += 1.0;
            continue;
        }
        let refuse = |(time, error)| refused(time, error);
        let mut look = |step: &Step<'_>| events.look(step);
        let mut reached = advance.to(&advancing, end, &mut look).map_err(refuse)?;
        if let Reached::Sample(state, _) = &reached
            && end >= settings.duration
            && !advance.is_at(settings, end)
            && let Some((time, state)) =
                advance.look_at(&advancing, (end, state), &mut look).map_err(refuse)?
        {
            reached = Reached::Stop(time, state);
        }
        let stopped = matches!(reached, Reached::Stop(..));
        (time, state) = match reached {
            Reached::Sample(state, _) => (end, state),
            Reached::Stop(time, state) => (time, state),
        };
        index += 1.0;
        watch.look(scene, time, &state);
        write(&sample(scene, time, &state, &mut angles).map_err(|error| refused(time, error))?)?;
        progress(Progress { time, share: time / settings.duration, steps: advance.steps });
        if stopped {
            break;
        }
    }
    let end = SavedState::new(scene, time, &advance, &angles, &state);
    Ok(Summary { advance, initial_residuals, end, spin: watch.warnings, events: events.passed })
}

pub(super) fn reason(scene: &Scene, error: StepError) -> String {
    match error {
        StepError::ConstraintsNotMet { joint, residual } => {
            let name = scene.connection_names.get(joint).map_or("?", String::as_str);
            // With the stiff modes taken implicitly their frequency is no limit.
            let explicit = scene.settings.integrator.is_explicit();
            let limit = scene
                .mechanism
                .largest_stable_step()
                .filter(|_| explicit)
                .map_or_else(String::new, |limit| {
                    format!("; the highest mode allows explicit steps of at most {limit:.3e} s")
                });
            format!(
                "joint `{name}` is off by {residual:.3e} (m or rad) and cannot be met again: reduce the step{limit}"
            )
        }
        StepError::BodyNotPositive { body, .. } => {
            let name = scene.body_names.get(body).map_or("?", String::as_str);
            error.to_string().replacen(&format!("body {body} "), &format!("body `{name}` "), 1)
        }
        other => other.to_string(),
    }
}
