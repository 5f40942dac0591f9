//! The events of a scene, looked for in every whole step of any integrator.
//!
//! A zero between both ends of a step is located by shorter steps from its beginning: the motion goes on as if nobody had
//! looked, and the state at an event meets the joints. Two zeros in one step are not seen.

use std::cell::Cell;

use ffrf_runtime::StepError;
use ffrf_runtime::mechanism::Constrained;

use super::advance::Step;
use super::events::zero;
use super::one_step::States;
use super::read_sensor;
use crate::scene::{Scene, SensorKind};

/// Share of a step within which an event is at the beginning of the run.
const BEGIN: f64 = 1e-9;

/// An event that happened.
#[derive(Debug, Clone, PartialEq)]
pub struct Passed {
    /// Its name.
    pub name: String,
    /// When. Units: s.
    pub time: f64,
    /// Whether the sensor passed the value from below.
    pub rising: bool,
}

/// Watches the events of a scene.
pub(super) struct Watch<'a> {
    scene: &'a Scene,
    /// What is left to the value of each event at the beginning of a step; the last that was not zero.
    pub(super) before: Vec<f64>,
    pub(super) passed: Vec<Passed>,
    /// Events at the beginning of a run have been: one that ended the run before it, for example. Units: s.
    begin: f64,
}

impl<'a> Watch<'a> {
    /// Errors: the sensors have no values at the beginning.
    pub(super) fn new(scene: &'a Scene, time: f64, state: &States) -> Result<Self, StepError> {
        let before = values(scene, time, state)?;
        Ok(Self { scene, before, passed: Vec::new(), begin: time })
    }

    /// A watch that goes on: what was left to each value, and where the run began (s).
    pub(super) fn resumed(scene: &'a Scene, before: Vec<f64>, begin: f64) -> Self {
        Self { scene, before, passed: Vec::new(), begin }
    }

    /// Looks at a step; gives time and state where the run ends.
    ///
    /// Errors: see [`StepError`], with the time of the step.
    pub(super) fn look(&mut self, step: &Step<'_>) -> Result<Option<(f64, States)>, (f64, StepError)> {
        let scene = self.scene;
        if scene.events.is_empty() {
            return Ok(None);
        }
        let (start, end) = (step.from, step.to.0);
        let now = values(scene, end, step.to.1).map_err(|error| (end, error))?;
        let mut found = Vec::new();
        for (index, event) in scene.events.iter().enumerate() {
            let (before, after) = (self.before[index], now[index]);
            let turned_over =
                matches!(event.kind, SensorKind::Angle(_)) && (after - before).abs() > std::f64::consts::PI;
            if before * after < 0.0 && !turned_over && event.direction.counts(after > 0.0) {
                let failed = Cell::new(None);
                let value = |share: f64| {
                    let time = start + share * (end - start);
                    let value = (step.between)(share * (end - start))
                        .and_then(|state| values(scene, time, &state))
                        .map(|values| values[index]);
                    value.unwrap_or_else(|error| {
                        failed.set(Some(error));
                        f64::NAN
                    })
                };
                let share = zero(value, [0.0, 1.0], [before, after]);
                if let Some(error) = failed.get() {
                    return Err((start, error));
                }
                found.push((share, index, after > 0.0));
            }
            if after != 0.0 {
                self.before[index] = after;
            }
        }
        found.sort_by(|one, other| one.0.total_cmp(&other.0));
        for (share, index, rising) in found {
            let event = &scene.events[index];
            let time = start + share * (end - start);
            if time <= self.begin + BEGIN * (end - start) {
                continue;
            }
            self.passed.push(Passed { name: event.name.clone(), time, rising });
            if event.stops {
                let state = (step.between)(share * (end - start)).map_err(|error| (start, error))?;
                return Ok(Some((time, state)));
            }
        }
        Ok(None)
    }
}

/// What each event's sensor has left to its value.
fn values(scene: &Scene, time: f64, state: &States) -> Result<Vec<f64>, StepError> {
    if scene.events.is_empty() {
        return Ok(Vec::new());
    }
    let mechanism = &scene.mechanism;
    Constrained(mechanism).evaluate(time, state.clone(), None, |ports, storage| {
        let mut numbers = Vec::new();
        scene
            .events
            .iter()
            .map(|event| {
                numbers.clear();
                read_sensor(&event.kind, mechanism, ports, storage, &mut None, &mut numbers);
                let left = numbers[event.component] - event.value;
                // angles within half a turn of the value
                if matches!(event.kind, SensorKind::Angle(_)) {
                    let turn = std::f64::consts::TAU;
                    left - turn * (left / turn).round()
                } else {
                    left
                }
            })
            .collect()
    })
}
