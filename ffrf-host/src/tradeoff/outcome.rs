//! What came of one configuration.

use ffrf_codegen::ScalarType;

use super::trajectory::trajectory;
use super::{Configuration, Reference, StaticCost, Study, Variant};
use crate::scene::StepChoice;

/// One configuration and what came of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// What was run.
    pub configuration: Configuration,
    /// What came of it.
    pub finding: Finding,
}

impl Outcome {
    /// Errors and cost, of a run that reached its end.
    pub fn measured(&self) -> Option<&Measured> {
        match &self.finding {
            Finding::Finished(measured) => Some(measured),
            Finding::Failed(_) => None,
        }
    }

    /// Numbers of the bodies in compiled code. Units: bytes.
    pub fn data_bytes(&self) -> Option<usize> {
        self.measured().map(|measured| measured.cost.constants * self.number_size())
    }

    /// What a step keeps on the stack, estimated. Units: bytes.
    pub fn stack_bytes(&self) -> Option<usize> {
        self.measured().map(|measured| measured.cost.stack_numbers * self.number_size())
    }

    /// Size of a number. Units: bytes.
    fn number_size(&self) -> usize {
        if self.configuration.scalar == ScalarType::F32 { 4 } else { 8 }
    }
}

/// What came of a run.
#[derive(Debug, Clone, PartialEq)]
pub enum Finding {
    /// It reached its end.
    Finished(Measured),
    /// It did not: when and why.
    Failed(String),
}

/// Instructions of compiled code per floating-point operation, about.
///
/// Source: `benches/instruction_counts.json` over the operations counted here: 5.6 for a pendulum of four modes, 7.3 for a
/// slider-crank of eight, whose redundant rows are solved more than once.
pub const INSTRUCTIONS_PER_OPERATION: f64 = 6.0;

/// Errors and cost of a run that reached its end.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The step that was taken: at most that of the configuration. Units: s.
    pub step: f64,
    /// Number of steps.
    pub steps: u64,
    /// Evaluations of the accelerations per step, with a factorisation each.
    pub evaluations: f64,
    /// For each channel the largest error over time, over the scale of the channel.
    pub errors: Vec<f64>,
    /// What an evaluation costs in compiled code.
    pub cost: StaticCost,
    /// Processor time of the host's steps. Units: s per simulated s.
    pub time: f64,
}

impl Measured {
    /// Floating-point operations of compiled code per step. Estimated, see [`StaticCost`].
    pub fn operations_per_step(&self) -> f64 {
        self.cost.operations * self.evaluations
    }

    /// The same per simulated second.
    pub fn operations_per_second(&self) -> f64 {
        self.operations_per_step() / self.step
    }

    /// The largest of the errors.
    pub fn error(&self) -> f64 {
        self.errors.iter().copied().fold(0.0, f64::max)
    }
}

/// Runs one configuration. `variant`: that of its modes and fidelity. What fails is an outcome as well.
pub fn run(
    study: &Study,
    variant: &Variant,
    reference: &Reference,
    configuration: &Configuration,
) -> Outcome {
    let finding = measure(study, variant, reference, configuration).unwrap_or_else(Finding::Failed);
    Outcome { configuration: configuration.clone(), finding }
}

fn measure(
    study: &Study,
    variant: &Variant,
    reference: &Reference,
    configuration: &Configuration,
) -> Result<Finding, String> {
    let Configuration { integrator, step, scalar, .. } = configuration;
    let settings =
        study.settings_of(*integrator, StepChoice::Fixed(*step)).map_err(|error| error.to_string())?;
    let (channels, times) = (&reference.channels, &reference.times);
    let ran = match scalar {
        ScalarType::F32 => trajectory::<f32>(variant, &settings, channels, times),
        ScalarType::F64 | ScalarType::Generic => trajectory::<f64>(variant, &settings, channels, times),
    };
    let (history, steps) = ran.map_err(|(time, error)| format!("t = {time:.3e} s: {error}"))?;
    let errors = reference.errors(&history);
    let (count, duration) = (steps.accepted.max(1) as f64, settings.duration);
    let iterations = steps.iterations as f64 / count;
    Ok(Finding::Finished(Measured {
        step: duration / count,
        steps: steps.accepted,
        evaluations: super::cost::evaluations_per_step(*integrator, iterations),
        errors,
        cost: variant.cost,
        time: steps.seconds / duration,
    }))
}
