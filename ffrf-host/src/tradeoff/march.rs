//! Advances a mechanism from one time of comparison to the next, in any number type.
//!
//! The simulation of scenes takes whole steps and shorter ones beside them for samples; a study takes equal steps that end at
//! its times, so that the step is what was asked for and costs nothing besides.

use ffrf_runtime::mechanism::Constrained;
use ffrf_runtime::{AlphaMemory, StepError, StepReport, System, try_dormand_prince};

use nalgebra::{RealField, convert, try_convert};

use crate::HostMechanism;
use crate::mechanism::HostIncrement;
use crate::scene::{Settings, StepChoice};
use crate::simulate::{States, step_in_space, tolerances};

/// The step sizes and counts of a simulation so far, in any number type.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct March<T: RealField + Copy = f64> {
    /// What an error-controlled integrator tries next. Units: s.
    pub(super) next_step: f64,
    /// Accepted steps.
    pub(super) steps: u64,
    /// Refused tries of error-controlled steps.
    pub(super) refused: u64,
    /// Iterations of all implicit steps.
    pub(super) iterations: u64,
    /// What the generalised-α method remembers of its last step.
    memory: Option<AlphaMemory<HostIncrement<T>>>,
}

/// From one sample to the next. Units: s.
struct Interval {
    start: f64,
    end: f64,
}

/// Smallest step of an error-controlled integrator, relative to the interval between samples.
const SMALLEST_SHARE: f64 = 1e-12;

/// A step is not cut shorter than this share of itself to end at a sample: it is stretched instead.
const STRETCH: f64 = 1e-9;

impl<T: RealField + Copy> March<T> {
    /// Before the first step.
    pub(super) fn new(settings: &Settings) -> Self {
        let next_step = match settings.step {
            StepChoice::Fixed(step) => step,
            StepChoice::Tolerance(_) => 1e-2 * settings.output_step,
        };
        Self { next_step, steps: 0, refused: 0, iterations: 0, memory: None }
    }

    /// The state at `end` (s), from `state` at `start` (s), in absolute coordinates; times are counted in f64. Fixed steps are
    /// equal, and at most as long as wanted.
    ///
    /// Errors: see [`StepError`], with the time of the step.
    pub(super) fn to(
        &mut self,
        mechanism: &HostMechanism<T>,
        settings: &Settings,
        state: States<T>,
        start: f64,
        end: f64,
    ) -> Result<States<T>, (f64, StepError)> {
        let step = |march: &mut Self, state: &States<T>, time: T, step: T| {
            step_in_space(mechanism, settings, &mut march.memory, state, time, step)
        };
        self.through(&Constrained(mechanism), settings.step, state, Interval { start, end }, step)
    }

    /// Steps through an interval: `fixed` takes one of a given size.
    fn through<S: System<T>>(
        &mut self,
        system: &S,
        choice: StepChoice,
        mut state: S::State,
        Interval { start, end }: Interval,
        fixed: impl Fn(&mut Self, &S::State, T, T) -> Result<(S::State, StepReport<T>), StepError>,
    ) -> Result<S::State, (f64, StepError)> {
        match choice {
            StepChoice::Fixed(longest) => {
                let count = ((end - start) / longest - STRETCH).ceil().max(1.0);
                let step = (end - start) / count;
                for k in 0..count as u64 {
                    let time = start + k as f64 * step;
                    let (next, report) =
                        fixed(self, &state, convert(time), convert(step)).map_err(|error| (time, error))?;
                    state = next;
                    self.accept(&report);
                }
            }
            StepChoice::Tolerance(relative) => {
                let tolerances = tolerances(relative);
                let mut time = start;
                while time < end {
                    let rest = end - time;
                    let last = self.next_step >= rest * (1.0 - STRETCH);
                    // a step that leaves only a little is halved
                    let step = if last { rest } else { self.next_step.min(0.5 * rest) };
                    let tried = try_dormand_prince(system, &state, convert(time), convert(step), &tolerances)
                        .map_err(|error| (time, error))?;
                    let proposed = try_convert(tried.next_step).unwrap_or(f64::NAN);
                    match tried.accepted {
                        Some((next, report)) => {
                            state = next;
                            time = if last { end } else { time + step };
                            self.accept(&report);
                            // a step cut short by a sample says little about the next one
                            self.next_step = if last { proposed.max(self.next_step) } else { proposed };
                        }
                        None => {
                            self.refused += 1;
                            self.next_step = proposed;
                            if self.next_step.is_nan() || self.next_step <= SMALLEST_SHARE * (end - start) {
                                return Err((time, StepError::StepSize { found: self.next_step }));
                            }
                        }
                    }
                }
            }
        }
        Ok(state)
    }

    fn accept(&mut self, report: &StepReport<T>) {
        self.steps += 1;
        self.iterations += report.iterations as u64;
    }
}
