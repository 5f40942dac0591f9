//! The least error that a step of given length and cost allows: for control loops, whose period and processor are given.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use ffrf_codegen::ScalarType;
use ffrf_runtime::mechanism::Assembly;

use super::super::cost::evaluations_per_step;
use super::super::trajectory::trajectory;
use super::super::{
    Configuration, Modes, Quantity, Reference, ReferenceOptions, Study, TradeoffError, Variant,
};
use super::motion;
use crate::scene::{Integrator, StepChoice};

/// Floating-point operations of compiled code that there is time for: where a number type is computed in software, fewer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Operations {
    /// In double precision.
    pub double: f64,
    /// In single precision.
    pub single: f64,
}

impl Operations {
    /// Those in a number type.
    pub fn of(&self, scalar: ScalarType) -> f64 {
        if scalar == ScalarType::F32 { self.single } else { self.double }
    }
}

/// What a period of a loop may take, and what may be chosen from.
#[derive(Debug, Clone, PartialEq)]
pub struct StepBudget {
    /// The period of the loop. Units: s.
    pub step: f64,
    /// What there is time for in a period.
    pub operations: Operations,
    /// Into how many equal steps of the integrator a period may be divided: one, for a step in a period.
    pub divisions: Vec<usize>,
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
    /// Steps in a period.
    pub divisions: usize,
    /// Operations of a period.
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
    /// The modes in the order of what they take part in the motion of the whole model.
    pub ranking: Vec<usize>,
}

/// An error counts as no better than another within this factor; the cheaper is taken then, and f32 before f64.
const ALIKE: f64 = 1.1;
/// Most models that are run for a kind, none with more modes than the one before.
const TRIES: usize = 8;

/// Plans a scene for steps of given length and cost: for each kind of model and integrator the most modes that there is time
/// for, the first ones and those that take part most, run against the whole model; the least error is taken.
///
/// More modes are taken to be no worse, as long as the step is stable with them. Errors: the scene cannot be simulated, or
/// nothing that may be chosen ends its run within the budget.
pub fn plan_within(study: &Study, budget: &StepBudget) -> Result<PlanWithin, TradeoffError> {
    let refused = || TradeoffError::StepBudget {
        operations: budget.operations.double.max(budget.operations.single),
        step: budget.step,
        tried: "it is longer than the scene".to_owned(),
    };
    let study = &study.in_steps_of(budget.step).ok_or_else(refused)?;
    let options = ReferenceOptions::default();
    let (reference, whole, states) = Reference::survey(study, &budget.quantities, options)?;
    let ranking = motion::look(study, &reference, &whole, &states)?.ranking();
    choose(study, reference, ranking, budget)
}

/// Chooses again, for other operations, with the reference of an earlier plan of the same study, period and quantities.
///
/// Errors: see [`plan_within`].
pub fn plan_again_within(
    study: &Study,
    earlier: &PlanWithin,
    budget: &StepBudget,
) -> Result<PlanWithin, TradeoffError> {
    match study.in_steps_of(budget.step) {
        Some(study) => choose(&study, earlier.reference.clone(), earlier.ranking.clone(), budget),
        None => plan_within(study, budget),
    }
}

fn choose(
    study: &Study,
    reference: Reference,
    ranking: Vec<usize>,
    budget: &StepBudget,
) -> Result<PlanWithin, TradeoffError> {
    let mut tried = Vec::new();
    let richest = study.richest();
    for fidelity in study.levels() {
        // without modes all fidelities are the same body
        let least = usize::from(fidelity != richest);
        let choices = choices(study.most_modes(), &ranking, least);
        let mut variants: BTreeMap<&Modes, Variant> = BTreeMap::new();
        for integrator in &budget.integrators {
            for (scalar, divisions) in
                budget.scalars.iter().flat_map(|scalar| budget.divisions.iter().map(move |d| (*scalar, *d)))
            {
                let step = budget.step / divisions.max(1) as f64;
                let operations = budget.operations.of(scalar) / divisions.max(1) as f64;
                let (mut tries, mut enough) = (0, 0);
                for modes in &choices {
                    // fewer modes where iterations made the step too dear, or where it was too long for them
                    if modes.count() < enough || tries == TRIES {
                        break;
                    }
                    let variant = match variants.entry(modes) {
                        Entry::Occupied(known) => known.into_mut(),
                        Entry::Vacant(place) => place.insert(study.variant(modes, &fidelity)?),
                    };
                    if !is_affordable(variant, step, operations, *integrator) {
                        continue;
                    }
                    let (fidelity, integrator) = (fidelity.clone(), *integrator);
                    let configuration =
                        Configuration { modes: modes.clone(), fidelity, scalar, integrator, step };
                    let one = run(study, &reference, variant, configuration, divisions.max(1));
                    tries += 1;
                    if one.error.is_ok() && one.share(budget) <= 1.0 {
                        enough = modes.count();
                    }
                    tried.push(one);
                }
            }
        }
    }
    let kept = |one: &Affordable| match one.error {
        Ok(error) if one.share(budget) <= 1.0 && error.is_finite() => Some(error),
        _ => None,
    };
    let least = tried.iter().filter_map(kept).fold(f64::INFINITY, f64::min);
    let alike = tried.iter().filter(|one| kept(one).is_some_and(|error| error <= ALIKE * least));
    let rank = |one: &Affordable| (one.share(budget), one.configuration.scalar.name());
    let best = alike.min_by(|a, b| {
        let (a, b) = (rank(a), rank(b));
        a.0.total_cmp(&b.0).then(a.1.cmp(b.1))
    });
    match best.and_then(|best| kept(best).map(|error| (best.clone(), error))) {
        Some((best, error)) => Ok(PlanWithin { best, error, tried, reference, ranking }),
        None => Err(TradeoffError::StepBudget {
            operations: budget.operations.double.max(budget.operations.single),
            step: budget.step,
            tried: tried.iter().map(Affordable::describe).collect::<Vec<_>>().join("; "),
        }),
    }
}

/// So many modes and no fewer than `least`, those of most first: the first ones, and those that take part most where these are others.
fn choices(most: usize, ranking: &[usize], least: usize) -> Vec<Modes> {
    let counts = (least..=most).rev();
    let both = counts.flat_map(|count| {
        let (first, ranked) =
            (Modes::first(count), Modes::listed(ranking.iter().copied().take(count).collect()));
        let is_another = ranked != first;
        std::iter::once(first).chain(is_another.then_some(ranked))
    });
    both.collect()
}

/// Whether a step has time for a model and is stable with it.
fn is_affordable(variant: &Variant, step: f64, allowed: f64, integrator: Integrator) -> bool {
    let operations = variant.cost.operations * evaluations_per_step(integrator, 1.0);
    let stable = variant.scene.mechanism.largest_stable_step().filter(|_| integrator.is_explicit());
    operations <= allowed && stable.is_none_or(|stable| step <= stable)
}

fn run(
    study: &Study,
    reference: &Reference,
    variant: &Variant,
    configuration: Configuration,
    divisions: usize,
) -> Affordable {
    let Configuration { integrator, step, scalar, .. } = configuration;
    let operations = |iterations: f64| {
        divisions as f64 * variant.cost.operations * evaluations_per_step(integrator, iterations)
    };
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
            divisions,
            operations: operations(steps.iterations as f64 / steps.accepted.max(1) as f64),
            error: Ok(reference.errors(&history).into_iter().fold(0.0, f64::max)),
        },
        Err(reason) => {
            Affordable { configuration, divisions, operations: operations(1.0), error: Err(reason) }
        }
    }
}

impl Affordable {
    /// What it takes of the time that there is.
    pub fn share(&self, budget: &StepBudget) -> f64 {
        self.operations / budget.operations.of(self.configuration.scalar)
    }

    /// In words.
    pub fn describe(&self) -> String {
        let Configuration { modes, fidelity, scalar, integrator, .. } = &self.configuration;
        let came = match &self.error {
            Ok(error) => format!("error {error:.1e}"),
            Err(reason) => reason.clone(),
        };
        let (scalar, integrator) = (scalar.name(), integrator.name());
        let steps = if self.divisions > 1 { format!(", {} steps", self.divisions) } else { String::new() };
        format!(
            "{modes} modes, {fidelity}, {scalar}, {integrator}{steps}: {:.3e} operations, {came}",
            self.operations
        )
    }
}
