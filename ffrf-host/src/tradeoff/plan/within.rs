//! The least error that a step of given length and cost allows: for control loops, whose period and processor are given.

use ffrf_codegen::{Fidelity, ScalarType};
use ffrf_runtime::mechanism::Assembly;

use super::super::cost::evaluations_per_step;
use super::super::trajectory::trajectory;
use super::super::{Configuration, Quantity, Reference, ReferenceOptions, Study, TradeoffError, Variant};
use super::model::LEVELS;
use crate::scene::{Integrator, StepChoice};

/// What a step may take, and what may be chosen from.
#[derive(Debug, Clone, PartialEq)]
pub struct StepBudget {
    /// The step of the integrator, equal to the period of the loop. Units: s.
    pub step: f64,
    /// Floating-point operations of compiled code that there is time for.
    pub operations: f64,
    /// What errors are taken in; see [`super::super::Channel::of`].
    pub quantities: Vec<Quantity>,
    /// Integrators to choose from.
    pub integrators: Vec<Integrator>,
    /// Number types to choose from.
    pub scalars: Vec<ScalarType>,
}

/// The richest model of a kind that a step has time for, and what came of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Affordable {
    /// Modes, terms, number type, integrator and step.
    pub configuration: Configuration,
    /// Operations of a step.
    pub operations: f64,
    /// Error against all modes and terms, over the scale of the worst quantity, or why the run ended early.
    pub error: Result<f64, String>,
}

/// A configuration for a time per step, with what it rests on.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanWithin {
    /// What is chosen.
    pub best: Affordable,
    /// Its error.
    pub error: f64,
    /// Everything that was run, the chosen one among it.
    pub tried: Vec<Affordable>,
    /// What errors were taken against.
    pub reference: Reference,
}

/// An error counts as no better than another within this factor; the cheaper is taken then, and f32 before f64.
const ALIKE: f64 = 1.1;
/// Most models that are run for a kind, each with fewer modes than the one before.
const TRIES: usize = 4;

/// Plans a scene for steps of given length and cost: for each kind of model and integrator the most modes that there is time
/// for, run against the whole model; the least error is taken.
///
/// More modes are taken to be no worse, as long as the step is stable with them. Errors: the scene cannot be simulated, or
/// nothing that may be chosen ends its run within the budget.
pub fn plan_within(study: &Study, budget: &StepBudget) -> Result<PlanWithin, TradeoffError> {
    let reference = Reference::compute(study, &budget.quantities, ReferenceOptions::default())?;
    let mut tried = Vec::new();
    for fidelity in LEVELS {
        let counts: Vec<usize> = match fidelity {
            Fidelity::Full => (0..=study.most_modes()).collect(),
            _ => (1..=study.most_modes()).collect(),
        };
        let variants: Vec<Variant> =
            counts.iter().map(|count| study.variant(*count, &fidelity)).collect::<Result<_, _>>()?;
        for integrator in &budget.integrators {
            for scalar in &budget.scalars {
                for (modes, variant) in affordable(budget, *integrator, &counts, &variants) {
                    let configuration = Configuration {
                        modes,
                        fidelity: fidelity.clone(),
                        scalar: *scalar,
                        integrator: *integrator,
                        step: budget.step,
                    };
                    let one = run(study, &reference, variant, configuration);
                    // fewer modes where iterations made the step too dear, or where it was too long for them
                    let enough = one.error.is_ok() && one.operations <= budget.operations;
                    tried.push(one);
                    if enough {
                        break;
                    }
                }
            }
        }
    }
    let kept = |one: &Affordable| match one.error {
        Ok(error) if one.operations <= budget.operations && error.is_finite() => Some(error),
        _ => None,
    };
    let least = tried.iter().filter_map(kept).fold(f64::INFINITY, f64::min);
    let alike = tried.iter().filter(|one| kept(one).is_some_and(|error| error <= ALIKE * least));
    let rank = |one: &Affordable| (one.operations, one.configuration.scalar.name());
    let best = alike.min_by(|a, b| {
        let (a, b) = (rank(a), rank(b));
        a.0.total_cmp(&b.0).then(a.1.cmp(b.1))
    });
    match best.and_then(|best| kept(best).map(|error| (best.clone(), error))) {
        Some((best, error)) => Ok(PlanWithin { best, error, tried, reference }),
        None => Err(TradeoffError::StepBudget {
            operations: budget.operations,
            step: budget.step,
            tried: tried.iter().map(Affordable::describe).collect::<Vec<_>>().join("; "),
        }),
    }
}

/// The models that a step has time for and is stable with, those of most modes first.
fn affordable<'a>(
    budget: &StepBudget,
    integrator: Integrator,
    counts: &[usize],
    variants: &'a [Variant],
) -> Vec<(usize, &'a Variant)> {
    let fits = |variant: &Variant| {
        let operations = variant.cost.operations * evaluations_per_step(integrator, 1.0);
        let stable = variant.scene.mechanism.largest_stable_step().filter(|_| integrator.is_explicit());
        operations <= budget.operations && stable.is_none_or(|stable| budget.step <= stable)
    };
    let all = counts.iter().copied().zip(variants).rev();
    all.filter(|(_, variant)| fits(variant)).take(TRIES).collect()
}

fn run(study: &Study, reference: &Reference, variant: &Variant, configuration: Configuration) -> Affordable {
    let Configuration { integrator, step, scalar, .. } = configuration;
    let operations = |iterations: f64| variant.cost.operations * evaluations_per_step(integrator, iterations);
    let ran = study.settings_of(integrator, StepChoice::Fixed(step)).map_err(|error| error.to_string());
    let ran = ran.and_then(|settings| {
        let Reference { channels, times, .. } = reference;
        let ran = match scalar {
            ScalarType::F32 => trajectory::<f32>(variant, &settings, channels, times),
            ScalarType::F64 | ScalarType::Generic => trajectory::<f64>(variant, &settings, channels, times),
        };
        ran.map_err(|(time, error)| format!("t = {time:.3e} s: {error}"))
    });
    match ran {
        Ok((history, steps)) => Affordable {
            configuration,
            operations: operations(steps.iterations as f64 / steps.accepted.max(1) as f64),
            error: Ok(reference.errors(&history).into_iter().fold(0.0, f64::max)),
        },
        Err(reason) => Affordable { configuration, operations: operations(1.0), error: Err(reason) },
    }
}

impl Affordable {
    /// In words.
    pub fn describe(&self) -> String {
        let Configuration { modes, fidelity, scalar, integrator, .. } = &self.configuration;
        let came = match &self.error {
            Ok(error) => format!("error {error:.1e}"),
            Err(reason) => reason.clone(),
        };
        let (scalar, integrator) = (scalar.name(), integrator.name());
        format!(
            "{modes} modes, {fidelity}, {scalar}, {integrator}: {:.3e} operations, {came}",
            self.operations
        )
    }
}
