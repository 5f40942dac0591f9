//! A run of a scene in a number type: the channels over time, and what the steps took.

use std::time::{Duration, Instant};

use ffrf_runtime::mechanism::{Assembly, Constrained};
use ffrf_runtime::{State, StepError, rotation};
use nalgebra::{RealField, try_convert};

use super::channel::{Channel, Source};
use super::effort::Stopwatch;
use super::march::March;
use super::study::Variant;
use crate::mechanism::HostMechanism;
use crate::scene::Settings;
use crate::simulate::{read_sensor, total_energy};
use crate::{HostBody, HostModal};

/// The channels at each time, one after the other.
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    /// For each time the numbers of all channels.
    pub values: Vec<Vec<f64>>,
}

/// What the steps of a run took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Steps {
    /// Accepted steps.
    pub(super) accepted: u64,
    /// Refused tries.
    pub(super) refused: u64,
    /// Iterations of implicit steps.
    pub(super) iterations: u64,
    /// Processor time of the steps, without sampling. Units: s.
    pub(super) seconds: f64,
}

/// The states of all bodies.
type States<T> = Vec<State<HostModal<T>, T>>;

/// Runs a variant through `times` (s). Errors: the time (s) and why a step was refused.
pub(super) fn trajectory<T: RealField + Copy>(
    variant: &Variant,
    settings: &Settings,
    channels: &[Channel],
    times: &[f64],
) -> Result<(History, Steps), (f64, StepError)> {
    let exact = variant.scene.mechanism.cast::<f64>().with_treatment(settings.treatment);
    let mechanism: HostMechanism<T> = exact.cast();
    let mut state = cast_states(&mechanism, &variant.initial);
    let mut march = March::<T>::new(settings);
    let mut angles = vec![None; channels.len()];
    let mut values = Vec::with_capacity(times.len());
    let watch = Stopwatch::start();
    let (begin, mut sampling) = (Instant::now(), Duration::ZERO);
    let mut before = 0.0;
    for (index, time) in times.iter().enumerate() {
        if index > 0 {
            state = march.to(&mechanism, settings, state, before, *time)?;
        }
        before = *time;
        let pause = Instant::now();
        values.push(
            sample(&mechanism, &exact, channels, *time, &state, &mut angles)
                .map_err(|error| (*time, error))?,
        );
        sampling += pause.elapsed();
    }
    let share = 1.0 - sampling.as_secs_f64() / begin.elapsed().as_secs_f64().max(f64::MIN_POSITIVE);
    let steps = Steps {
        accepted: march.steps,
        refused: march.refused,
        iterations: march.iterations,
        seconds: watch.seconds() * share.max(0.0),
    };
    Ok((History { values }, steps))
}

fn sample<T: RealField + Copy>(
    mechanism: &HostMechanism<T>,
    exact: &HostMechanism,
    channels: &[Channel],
    time: f64,
    state: &States<T>,
    angles: &mut [Option<T>],
) -> Result<Vec<f64>, StepError> {
    let mut values = Vec::new();
    let at: T = nalgebra::convert(time);
    Constrained(mechanism).evaluate(at, state.clone(), None, |ports, storage| {
        for (channel, angle) in channels.iter().zip(angles) {
            match &channel.source {
                Source::Sensor(kind) => read_sensor(kind, mechanism, ports, storage, angle, &mut values),
                Source::Place(body) => values.extend_from_slice(state[*body].position.as_slice()),
                Source::Orientation(body) => {
                    values.extend(rotation::euler_parameters(&state[*body].orientation))
                }
                Source::State(body, _) => values.extend(state[*body].numbers()),
                Source::Energy => values.push(energy(exact, time, state)),
            }
        }
    })?;
    let values: Vec<f64> = values.into_iter().map(plain).collect();
    if values.iter().all(|value| value.is_finite()) {
        Ok(values)
    } else {
        Err(StepError::NonFiniteResult { largest_stable_step: exact.largest_stable_step() })
    }
}

/// The energy that a state has, computed in f64 whatever its numbers are.
fn energy<T: RealField + Copy>(exact: &HostMechanism, time: f64, state: &States<T>) -> T {
    let exact_state: States<f64> =
        exact.bodies().iter().zip(state).map(|(body, state)| plain_state(body, state)).collect();
    let found = Constrained(exact)
        .evaluate(time, exact_state.clone(), None, |ports, _| total_energy(exact, &exact_state, ports));
    nalgebra::convert(found.unwrap_or(f64::NAN))
}

fn plain_state<T: RealField + Copy>(body: &HostBody, state: &State<HostModal<T>, T>) -> State<HostModal> {
    let mut exact = State::at_rest(body);
    exact.set_numbers(&mut state.numbers().map(plain));
    exact
}

fn cast_states<T: RealField + Copy>(mechanism: &HostMechanism<T>, states: &[State<HostModal>]) -> States<T> {
    let bodies = mechanism.bodies().iter().zip(states);
    bodies
        .map(|(body, state)| {
            let mut cast = State::at_rest(body);
            cast.set_numbers(&mut state.numbers().map(nalgebra::convert));
            cast
        })
        .collect()
}

fn plain<T: RealField + Copy>(value: T) -> f64 {
    try_convert(value).unwrap_or(f64::NAN)
}
