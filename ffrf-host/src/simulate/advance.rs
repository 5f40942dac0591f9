//! Advances a mechanism from one sample to the next.

use ffrf_runtime::mechanism::Constrained;
use ffrf_runtime::{
    Drift, State, StepError, Tolerances, step_dormand_prince, step_linearly_implicit, step_rk4,
    step_symplectic_euler, try_dormand_prince,
};

use crate::scene::{Integrator, Settings, StepChoice};
use crate::{HostMechanism, HostModal};

/// The step sizes and counts of a simulation so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Advance {
    /// What an error-controlled integrator tries next. Units: s.
    pub next_step: f64,
    /// Accepted steps.
    pub steps: u64,
    /// Refused tries of error-controlled steps.
    pub refused: u64,
    /// Largest drift from the constraints of a step, before it was corrected.
    pub drift: Drift,
}

/// Smallest step of an error-controlled integrator, relative to the interval between samples.
const SMALLEST_SHARE: f64 = 1e-12;

/// A step is not cut shorter than this share of itself to end at a sample: it is stretched instead.
const STRETCH: f64 = 1e-9;

impl Advance {
    /// Before the first step.
    pub fn new(settings: &Settings) -> Self {
        let next_step = match settings.step {
            StepChoice::Fixed(step) => step,
            StepChoice::Tolerance(_) => 1e-2 * settings.output_step,
        };
        Self { next_step, steps: 0, refused: 0, drift: Drift::none() }
    }

    /// The state at `end`, from `state` at `start`. Fixed steps are equal, and at most as long as wanted.
    ///
    /// Errors: see [`StepError`], with the time of the step.
    pub fn to(
        &mut self,
        mechanism: &HostMechanism,
        settings: &Settings,
        mut state: Vec<State<HostModal>>,
        start: f64,
        end: f64,
    ) -> Result<Vec<State<HostModal>>, (f64, StepError)> {
        let system = Constrained(mechanism);
        match settings.step {
            StepChoice::Fixed(longest) => {
                let count = ((end - start) / longest - STRETCH).ceil().max(1.0);
                let step = (end - start) / count;
                for k in 0..count as u64 {
                    let time = start + k as f64 * step;
                    let result = match settings.integrator {
                        Integrator::SymplecticEuler => step_symplectic_euler(&system, &state, time, step),
                        Integrator::Rk4 => step_rk4(&system, &state, time, step),
                        Integrator::Dopri5 => step_dormand_prince(&system, &state, time, step),
                        Integrator::LinearlyImplicit => step_linearly_implicit(&system, &state, time, step),
                    };
                    let (next, report) = result.map_err(|error| (time, error))?;
                    state = next;
                    self.accept(report.drift);
                }
            }
            StepChoice::Tolerance(relative) => {
                let tolerances = Tolerances { relative, absolute: relative * ABSOLUTE_SHARE };
                let mut time = start;
                while time < end {
                    let rest = end - time;
                    let last = self.next_step >= rest * (1.0 - STRETCH);
                    // a step that leaves only a little is halved
                    let step = if last { rest } else { self.next_step.min(0.5 * rest) };
                    let tried = try_dormand_prince(&system, &state, time, step, &tolerances)
                        .map_err(|error| (time, error))?;
                    match tried.accepted {
                        Some((next, report)) => {
                            state = next;
                            time = if last { end } else { time + step };
                            self.accept(report.drift);
                            // a step cut short by a sample says little about the next one
                            self.next_step =
                                if last { tried.next_step.max(self.next_step) } else { tried.next_step };
                        }
                        None => {
                            self.refused += 1;
                            self.next_step = tried.next_step;
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

    fn accept(&mut self, drift: Drift) {
        self.steps += 1;
        self.drift.position = self.drift.position.max(drift.position);
        self.drift.velocity = self.drift.velocity.max(drift.velocity);
    }
}

/// Absolute tolerance of a component over the relative one, in units of that component (m, rad, m/s, ...).
const ABSOLUTE_SHARE: f64 = 1e-2;
