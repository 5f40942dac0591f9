//! What errors are taken against: every mode and every term that the bodies hold, integrated with error control, twice.

use std::thread;

use ffrf_codegen::Fidelity;
use ffrf_runtime::{Observables, State};

use super::channel::{Channel, Source};
use super::trajectory::{History, trajectory};
use super::{Quantity, Study, TradeoffError, Variant};
use crate::HostBody;
use crate::scene::{Integrator, StepChoice};

/// How the reference is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReferenceOptions {
    /// Relative tolerance per step of Dormand-Prince 5(4); the second run, which tells the error, has `COARSER` times as much.
    pub tolerance: f64,
}

impl Default for ReferenceOptions {
    fn default() -> Self {
        Self { tolerance: 1e-10 }
    }
}

/// The tolerance of the run that tells the error of the reference, over that of the reference.
const COARSER: f64 = 30.0;

/// The least scale of a channel over the largest of its unit. What is smaller, a reaction across a planar motion say, is
/// round-off or no matter, and would otherwise be all that the worst error shows.
const LEAST_SCALE: f64 = 1e-3;

/// The reference of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// What is compared.
    pub channels: Vec<Channel>,
    /// Times of the comparison. Units: s.
    pub times: Vec<f64>,
    /// The channels at these times.
    pub history: History,
    /// What errors of each channel are divided by: the farthest that a place goes from where it began, the largest kinetic and
    /// elastic energy, the largest size of anything else. Units: those of the channel.
    pub scales: Vec<f64>,
    /// Its own error in each channel, over the scale: the difference to a run of a coarser tolerance, which is less exact.
    pub own_errors: Vec<f64>,
    /// Relative tolerance per step.
    pub tolerance: f64,
    /// Steps.
    pub steps: u64,
    /// Modes of the body that has most.
    pub modes: usize,
    /// Every term of the kinetic energy that all bodies hold.
    pub fidelity: Fidelity,
}

impl Reference {
    /// Computes the reference of a study. Errors: see [`TradeoffError`].
    pub fn compute(
        study: &Study,
        quantities: &[Quantity],
        options: ReferenceOptions,
    ) -> Result<Self, TradeoffError> {
        Ok(Self::survey(study, quantities, options)?.0)
    }

    /// The reference, the whole scene, and for each time the numbers of the states of its bodies, one after the other.
    pub(super) fn survey(
        study: &Study,
        quantities: &[Quantity],
        options: ReferenceOptions,
    ) -> Result<(Self, Variant, Vec<Vec<f64>>), TradeoffError> {
        let fidelity = study.richest();
        let variant = study.variant(&study.all_modes(), &fidelity)?;
        let channels = Channel::of(&variant.scene, quantities)?;
        let width: usize = channels.iter().map(Channel::width).sum();
        let mut everything = channels.clone();
        everything.extend(Channel::states(&variant.scene));
        let times = study.times();
        let coarser = || controlled(study, &variant, &channels, &times, COARSER * options.tolerance);
        let (fine, coarse) = thread::scope(|scope| {
            let coarse = scope.spawn(coarser);
            (controlled(study, &variant, &everything, &times, options.tolerance), coarse.join())
        });
        let (mut history, steps) = fine?;
        // a thread that panicked has said why; its run is made once more, and so is its panic
        let (coarse, _) = coarse.unwrap_or_else(|_| coarser())?;
        let states: Vec<Vec<f64>> = history.values.iter_mut().map(|row| row.split_off(width)).collect();
        let moving = states.iter().map(|row| motion_energy(&variant, row)).fold(0.0, f64::max);
        let scales = scales(&channels, &history, moving);
        let mut reference = Self {
            channels,
            times,
            history,
            scales,
            own_errors: Vec::new(),
            tolerance: options.tolerance,
            steps,
            modes: study.most_modes(),
            fidelity,
        };
        reference.own_errors = reference.errors(&coarse);
        Ok((reference, variant, states))
    }

    /// The largest error over time of each channel, over its scale.
    pub fn errors(&self, history: &History) -> Vec<f64> {
        self.distances(&self.history, history)
    }

    /// The farthest that two runs are from each other in each channel, over its scale.
    pub(super) fn distances(&self, first: &History, second: &History) -> Vec<f64> {
        let mut start = 0;
        let channels = self.channels.iter().zip(&self.scales);
        channels
            .map(|(channel, scale)| {
                let range = start..start + channel.width();
                start = range.end;
                let pairs = first.values.iter().zip(&second.values);
                let worst = pairs
                    .map(|(exact, found)| distance(channel, &exact[range.clone()], &found[range.clone()]));
                // a maximum that keeps what is not a number
                worst.fold(0.0, |worst: f64, one| if one > worst || one.is_nan() { one } else { worst })
                    / scale
            })
            .collect()
    }

    /// The largest of its own errors.
    pub fn own_error(&self) -> f64 {
        self.own_errors.iter().copied().fold(0.0, f64::max)
    }
}

/// A run with error control, and its steps.
pub(super) fn controlled(
    study: &Study,
    variant: &Variant,
    channels: &[Channel],
    times: &[f64],
    tolerance: f64,
) -> Result<(History, u64), TradeoffError> {
    let settings = study.settings_of(Integrator::Dopri5, StepChoice::Tolerance(tolerance))?;
    let (history, steps) =
        trajectory::<f64>(variant, &settings, channels, times).map_err(|(time, error)| {
            TradeoffError::Reference { tolerance, reason: format!("t = {time:.9e} s: {error}") }
        })?;
    Ok((history, steps.accepted))
}

fn distance(channel: &Channel, exact: &[f64], found: &[f64]) -> f64 {
    let by = |sign: f64| {
        exact.iter().zip(found).map(|(exact, found)| (exact - sign * found).powi(2)).sum::<f64>().sqrt()
    };
    if channel.is_orientation() { by(1.0).min(by(-1.0)) } else { by(1.0) }
}

/// Kinetic and elastic energy of all bodies, from the numbers of their states. Units: J.
fn motion_energy(variant: &Variant, numbers: &[f64]) -> f64 {
    let mut numbers = numbers.iter().copied();
    let one = |body: &HostBody| {
        let mut state = State::at_rest(body);
        state.set_numbers(&mut numbers);
        let (q, velocity) = (&state.modal_coordinates, state.body_velocity());
        body.kinetic_energy(q, &velocity, &state.angular_velocity, &state.modal_rates)
            + body.elastic_energy(q)
    };
    variant.scene.mechanism.bodies().iter().map(one).sum()
}

/// `moving`: the largest kinetic and elastic energy (J), the scale of energies: where the potential energy is zero is a choice,
/// and all together may be zero throughout.
fn scales(channels: &[Channel], history: &History, moving: f64) -> Vec<f64> {
    let mut start = 0;
    let own: Vec<f64> = channels
        .iter()
        .map(|channel| {
            let range = start..start + channel.width();
            start = range.end;
            let first = history.values.first().map(|row| &row[range.clone()]);
            if channel.source == Source::Energy {
                return moving;
            }
            let sizes = history.values.iter().map(|row| match first {
                Some(first) if channel.is_place() => distance(channel, first, &row[range.clone()]),
                _ => row[range.clone()].iter().map(|x| x * x).sum::<f64>().sqrt(),
            });
            sizes.fold(0.0, f64::max)
        })
        .collect();
    let largest = |unit: &str| {
        let alike = channels.iter().zip(&own).filter(|(channel, _)| channel.unit == unit);
        alike.map(|(_, scale)| *scale).fold(0.0, f64::max)
    };
    let floored = channels.iter().zip(&own).map(|(channel, scale)| {
        let scale = scale.max(LEAST_SCALE * largest(channel.unit));
        // what never moves has no scale but its unit
        if scale > 0.0 { scale } else { 1.0 }
    });
    floored.collect()
}
