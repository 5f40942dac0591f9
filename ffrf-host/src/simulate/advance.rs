//! Advances a mechanism from one sample to the next.

use ffrf_runtime::mechanism::Constrained;
use ffrf_runtime::{
    AlphaMemory, ControlledStep, Drift, StepError, StepReport, System, Tolerances, try_dormand_prince,
};

use super::one_step::{States, explicit_step, step_in_space, tolerances};
use crate::HostMechanism;
use crate::mechanism::{HostIncrement, JointCoordinates};
use crate::scene::{Settings, StepChoice};

/// How far a simulation has come: the last whole step, and counts.
///
/// Whole steps follow each other as if nothing were sampled; a sample between two of them is the end of a shorter step
/// beside them. So the motion does not depend on `output_step`.
#[derive(Debug, Clone, PartialEq)]
pub struct Advance {
    /// The state after the last whole step.
    pub state: States,
    /// Its time. Units: s.
    pub time: f64,
    /// Where fixed steps are counted from (s), and how many of them have been done since.
    grid: (f64, u64),
    /// What an error-controlled integrator tries next. Units: s.
    pub next_step: f64,
    /// Whole steps.
    pub steps: u64,
    /// Shorter steps beside them, for samples.
    pub side_steps: u64,
    /// Refused tries of error-controlled steps.
    pub refused: u64,
    /// Largest drift from the constraints of a step, before it was corrected.
    pub drift: Drift,
    /// Most iterations that an implicit step took.
    pub iterations: usize,
    /// What the generalised-α method remembers of its last step.
    pub memory: Option<AlphaMemory<HostIncrement>>,
}

/// A step that was done and is not yet taken.
pub(super) struct Step<'a> {
    /// Time at its beginning. Units: s.
    pub(super) from: f64,
    /// Time (s) and state at its end.
    pub(super) to: (f64, &'a States),
    /// The state some time (s) after its beginning, by a shorter step.
    pub(super) between: &'a dyn Fn(f64) -> Result<States, StepError>,
}

/// Looks at each step; a time and a state end the run there.
pub(super) type Looking<'a> = dyn FnMut(&Step<'_>) -> Result<Stop, (f64, StepError)> + 'a;

/// Time (s) and state where a run ends early.
pub(super) type Stop = Option<(f64, States)>;

/// Where an advance has come to.
pub(super) enum Reached {
    /// To the time that was asked for; with what the generalised-α method remembers there.
    Sample(States, Option<AlphaMemory<HostIncrement>>),
    /// To an event that ends the run.
    Stop(f64, States),
}

/// What is advanced, and how.
#[derive(Clone, Copy)]
pub struct Advancing<'a> {
    /// The mechanism.
    pub mechanism: &'a HostMechanism,
    /// The joint coordinates of the mechanism, if they are what is integrated; explicit integrators only, others stay in
    /// absolute coordinates.
    pub tree: Option<&'a JointCoordinates<'a>>,
    /// How.
    pub settings: &'a Settings,
}

/// Smallest step of an error-controlled integrator, relative to the time it has come to or has to go.
const SMALLEST_SHARE: f64 = 1e-12;

/// A sample as close as this share of a step to the end of a whole step is that end.
const SAME_TIME: f64 = 1e-9;

/// First step of an error-controlled integrator where nothing moves. Units: s.
const FIRST_STEP: f64 = 1e-3;

impl Advance {
    /// Before the first step.
    pub fn new(settings: &Settings, time: f64, state: States) -> Self {
        let (next_step, grid, time) = match settings.step {
            // steps stand on a grid that begins at zero, if the state does; before zero there is none
            StepChoice::Fixed(step) => {
                let count = (time / step).round();
                let on_grid = count >= 0.0 && (time - count * step).abs() <= SAME_TIME * step;
                if on_grid { (step, (0.0, count as u64), count * step) } else { (step, (time, 0), time) }
            }
            StepChoice::Tolerance(_) => (0.0, (time, 0), time),
        };
        Self {
            state,
            time,
            grid,
            next_step,
            steps: 0,
            side_steps: 0,
            refused: 0,
            drift: Drift::none(),
            iterations: 0,
            memory: None,
        }
    }

    /// Where fixed steps are counted from (s), and how many of them have been done since.
    pub(super) fn grid(&self) -> (f64, u64) {
        self.grid
    }

    /// Takes up steps where they were: what [`Advance::grid`] gave, the end of the last whole step (s), and the next (s).
    pub(super) fn take_up(&mut self, grid: (f64, u64), time: f64, next_step: f64) {
        (self.grid, self.time, self.next_step) = (grid, time, next_step);
    }

    /// The same run, whose steps begin anew at a time (s) and state after the last whole step.
    pub(super) fn restarted(
        &self,
        settings: &Settings,
        time: f64,
        state: States,
        memory: Option<AlphaMemory<HostIncrement>>,
    ) -> Self {
        let Self { time, grid, state, .. } = Self::new(settings, time, state);
        Self { time, grid, state, memory, ..self.clone() }
    }

    /// Whether a whole step has ended at `time` (s).
    pub(super) fn is_at(&self, settings: &Settings, time: f64) -> bool {
        match settings.step {
            StepChoice::Fixed(step) => (time - self.time).abs() <= SAME_TIME * step,
            StepChoice::Tolerance(_) => self.time == time,
        }
    }

    /// The state at `time` (s), not before the last whole step.
    ///
    /// Errors: see [`StepError`], with the time of the step.
    pub(super) fn to(
        &mut self,
        advancing: &Advancing<'_>,
        time: f64,
        look: &mut Looking<'_>,
    ) -> Result<Reached, (f64, StepError)> {
        match advancing.settings.step {
            StepChoice::Fixed(step) => self.fixed_to(advancing, step, time, look),
            StepChoice::Tolerance(relative) => {
                self.controlled_to(advancing, &tolerances(relative), time, look)
            }
        }
    }

    fn fixed_to(
        &mut self,
        advancing: &Advancing<'_>,
        step: f64,
        time: f64,
        look: &mut Looking<'_>,
    ) -> Result<Reached, (f64, StepError)> {
        let whole = ((time - self.grid.0) / step + SAME_TIME).floor();
        while (self.grid.1 as f64) < whole {
            let (at, mut memory) = (self.time, self.memory.clone());
            let (state, report) =
                advancing.step(&mut memory, &self.state, at, step).map_err(|error| (at, error))?;
            let reached = self.grid.0 + (self.grid.1 + 1) as f64 * step;
            if let Some((time, state)) = self.look_at(advancing, (reached, &state), look)? {
                return Ok(Reached::Stop(time, state));
            }
            (self.state, self.memory, self.time) = (state, memory, reached);
            self.grid.1 += 1;
            self.accept(&report);
        }
        let rest = time - self.time;
        if rest <= SAME_TIME * step {
            return Ok(Reached::Sample(self.state.clone(), self.memory.clone()));
        }
        self.side_steps += 1;
        let mut memory = self.memory.clone();
        let side = advancing.step(&mut memory, &self.state, self.time, rest);
        side.map(|(state, _)| Reached::Sample(state, memory)).map_err(|error| (self.time, error))
    }

    fn controlled_to(
        &mut self,
        advancing: &Advancing<'_>,
        tolerances: &Tolerances<f64>,
        time: f64,
        look: &mut Looking<'_>,
    ) -> Result<Reached, (f64, StepError)> {
        if self.next_step <= 0.0 {
            self.next_step = advancing
                .first_step(&self.state, self.time, tolerances)
                .map_err(|error| (self.time, error))?;
        }
        while self.time + self.next_step <= time {
            let at = self.time;
            let tried = advancing
                .try_step(&self.state, at, self.next_step, tolerances)
                .map_err(|error| (at, error))?;
            match tried.accepted {
                Some((state, report)) => {
                    let reached = at + self.next_step;
                    if let Some((time, state)) = self.look_at(advancing, (reached, &state), look)? {
                        return Ok(Reached::Stop(time, state));
                    }
                    (self.state, self.time) = (state, reached);
                    self.accept(&report);
                }
                None => self.refused += 1,
            }
            self.next_step = tried.next_step;
            self.check_step(at, time)?;
        }
        // the rest beside the whole steps, under the same control
        let mut side = Self { next_step: time - self.time, ..self.clone() };
        while side.time < time {
            let rest = time - side.time;
            let step = side.next_step.min(rest);
            let tried = advancing
                .try_step(&side.state, side.time, step, tolerances)
                .map_err(|error| (side.time, error))?;
            side.next_step = tried.next_step;
            match tried.accepted {
                Some((state, _)) => {
                    side.state = state;
                    side.time = if step < rest { side.time + step } else { time };
                    self.side_steps += 1;
                }
                None => {
                    self.refused += 1;
                    side.check_step(side.time, time)?;
                }
            }
        }
        Ok(Reached::Sample(side.state, None))
    }

    /// Looks at what is between the last whole step and a time (s) and state after it.
    pub(super) fn look_at(
        &self,
        advancing: &Advancing<'_>,
        to: (f64, &States),
        look: &mut Looking<'_>,
    ) -> Result<Stop, (f64, StepError)> {
        let between = |step: f64| {
            advancing.step(&mut self.memory.clone(), &self.state, self.time, step).map(|(state, _)| state)
        };
        look(&Step { from: self.time, to, between: &between })
    }

    /// Errors: the step that an error-controlled integrator asks for leads nowhere.
    fn check_step(&self, at: f64, end: f64) -> Result<(), (f64, StepError)> {
        let smallest = SMALLEST_SHARE * at.abs().max(end - at);
        if self.next_step.is_nan() || self.next_step <= smallest {
            return Err((at, StepError::StepSize { found: self.next_step }));
        }
        Ok(())
    }

    fn accept(&mut self, report: &StepReport) {
        self.steps += 1;
        self.drift.position = self.drift.position.max(report.drift.position);
        self.drift.velocity = self.drift.velocity.max(report.drift.velocity);
        self.iterations = self.iterations.max(report.iterations);
    }
}

impl Advancing<'_> {
    /// One step of the method of the scene. Errors: see [`StepError`].
    fn step(
        &self,
        memory: &mut Option<AlphaMemory<HostIncrement>>,
        state: &States,
        time: f64,
        step: f64,
    ) -> Result<(States, StepReport), StepError> {
        let integrator = self.settings.integrator;
        match self.tree {
            Some(tree) if integrator.is_explicit() => {
                let (state, report) = explicit_step(integrator, tree, &tree.relative(state), time, step)?;
                Ok((tree.absolute(&state), report))
            }
            _ => step_in_space(self.mechanism, self.settings, memory, state, time, step),
        }
    }

    /// One try of an error-controlled step. Errors: see [`StepError`].
    fn try_step(
        &self,
        state: &States,
        time: f64,
        step: f64,
        tolerances: &Tolerances<f64>,
    ) -> Result<ControlledStep<States>, StepError> {
        let Some(tree) = self.tree else {
            return try_dormand_prince(&Constrained(self.mechanism), state, time, step, tolerances);
        };
        let ControlledStep { accepted, next_step } =
            try_dormand_prince(tree, &tree.relative(state), time, step, tolerances)?;
        let accepted = accepted.map(|(state, report)| (tree.absolute(&state), report));
        Ok(ControlledStep { accepted, next_step })
    }

    /// A first step that changes the state by about a hundredth of itself, or of the absolute tolerance over the relative.
    ///
    /// Source: Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, II.4 (the first of its two guesses).
    fn first_step(&self, state: &States, time: f64, tolerances: &Tolerances<f64>) -> Result<f64, StepError> {
        let system = Constrained(self.mechanism);
        let rates = system.rates(time, state, &system.no_change(state))?;
        let size = system.weighted_error(state, &rates, tolerances) * tolerances.relative;
        Ok(if size > 0.0 { (0.01 / size).min(FIRST_STEP) } else { FIRST_STEP })
    }
}
