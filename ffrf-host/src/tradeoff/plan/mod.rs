//! A configuration for a budget: how few modes and terms, how large a step, and which integrator.
//!
//! The error of a configuration is at most the sum of what the model lacks (the distance of the exactly integrated smaller
//! model from the exactly integrated whole one) and of what the steps add (the distance of its own run from that): the largest
//! error over time is a norm. So both are looked for apart: modes and terms with error control, by few runs; steps by pilot runs
//! that are cheaper than the final one, and by the order of the method from there on.

mod model;
mod modes;
mod motion;
mod spectrum;
mod statics;
mod steps;
mod terms;
mod track;
mod within;

use ffrf_codegen::{Fidelity, ScalarType};

use super::{Configuration, Modes, Quantity, Reference, ReferenceOptions, Study, TradeoffError};
use crate::scene::Integrator;

pub use model::Choice;
pub use modes::ModeUse;
pub use motion::Motion;
pub use statics::Truncation;
pub use steps::{Candidate, Pilot};
pub use terms::TermUse;
pub use within::{Affordable, Operations, PlanWithin, StepBudget, plan_again_within, plan_within};

/// What a plan may choose from, and for what.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanOptions {
    /// The largest error over time and quantities, over the scale of each quantity.
    pub error: f64,
    /// What errors are taken in; see [`super::Channel::of`].
    pub quantities: Vec<Quantity>,
    /// Integrators to choose from.
    pub integrators: Vec<Integrator>,
    /// Number types to choose from; the smaller is taken where its rounding is small against the budget.
    pub scalars: Vec<ScalarType>,
}

/// One method for what is not stiff and its fellow of higher order, and two that take stiff modes implicitly.
const INTEGRATORS: [Integrator; 4] =
    [Integrator::Rk4, Integrator::Dopri5, Integrator::LinearlyImplicit, Integrator::GeneralizedAlpha];

impl PlanOptions {
    /// What is usual for an error that is allowed: every sensor, four integrators, both number types.
    pub fn usual(error: f64) -> Self {
        let scalars = vec![ScalarType::F64, ScalarType::F32];
        Self { error, quantities: Vec::new(), integrators: INTEGRATORS.to_vec(), scalars }
    }
}

/// A configuration for a budget, with what it rests on.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// What is chosen.
    pub configuration: Configuration,
    /// Error that is expected: of the model, of the steps, of rounding, and of the reference, added.
    pub predicted_error: f64,
    /// These four.
    pub parts: [f64; 4],
    /// Floating-point operations of compiled code per step and per simulated second, estimated.
    pub operations: [f64; 2],
    /// The reference that it was planned with.
    pub reference: Reference,
    /// What the motion of the whole model is like.
    pub motion: Motion,
    /// What the modes that are dropped do to each channel of places.
    pub truncations: Vec<Truncation>,
    /// The models that were tried, in the order in which they were.
    pub models: Vec<Choice>,
    /// The best of each integrator with each model that was left.
    pub candidates: Vec<Candidate>,
}

/// Tolerance of the first reference over the budget: a step's error is a small part of a run's.
const FIRST_TOLERANCE: f64 = 1e-3;
/// The own error of the reference over the budget: small enough to be no matter.
const OWN_SHARE: f64 = 0.05;
/// The largest share of the budget that the model may take; the smaller leaves more for the steps.
const MODEL_SHARES: [f64; 2] = [0.8, 0.4];
/// The largest share of the budget that rounding may take.
const ROUNDING_SHARE: f64 = 0.2;
/// A term whose bound is below this share of the budget is dropped without a trial of its own: in a free body a force that is
/// wrong by a share makes a motion wrong by more than that, with time.
const NEGLIGIBLE: f64 = 1e-2;
/// How often the reference is made more exact before its error is taken as it is.
const REFINEMENTS: usize = 4;

/// Plans a scene. Errors: the scene cannot be simulated, or nothing that may be chosen keeps the budget.
pub fn plan(study: &Study, options: &PlanOptions) -> Result<Plan, TradeoffError> {
    let mut tolerance = (FIRST_TOLERANCE * options.error).clamp(1e-12, 1e-5);
    let (mut reference, mut whole, mut states) = survey(study, options, tolerance)?;
    for _ in 0..REFINEMENTS {
        let own = reference.own_error();
        if own <= OWN_SHARE * options.error || tolerance <= 1e-13 {
            break;
        }
        // the error of a run is about in proportion to the tolerance of its steps
        tolerance *= (0.5 * OWN_SHARE * options.error / own).max(1e-3);
        (reference, whole, states) = survey(study, options, tolerance)?;
    }
    let motion = motion::look(study, &reference, &whole, &states)?;
    let needed = study.held().completed(motion.needed_terms(NEGLIGIBLE * options.error));
    let mut search = model::Search::new(study, &reference, tolerance, needed, motion.ranking());
    let mut left: Vec<(Modes, Fidelity)> = Vec::new();
    for share in MODEL_SHARES {
        if let Some(choice) = search.least(share * options.error)
            && !left.contains(&choice)
        {
            left.push(choice);
        }
    }
    if left.is_empty() {
        left.push((study.all_modes(), study.richest()));
    }
    let mut candidates: Vec<Candidate> = Vec::new();
    for (modes, fidelity) in &left {
        let Some(model) = search.model(modes, fidelity) else { continue };
        for integrator in &options.integrators {
            let cheapest = candidates.iter().filter_map(Candidate::cost).fold(f64::INFINITY, f64::min);
            candidates.push(steps::candidate(study, &reference, model, *integrator, options.error, cheapest));
        }
    }
    let best = candidates
        .iter()
        .filter(|candidate| candidate.cost().is_some())
        .min_by(|a, b| a.cost().unwrap_or(f64::INFINITY).total_cmp(&b.cost().unwrap_or(f64::INFINITY)));
    let Some((best, step)) = best.and_then(|best| best.step.map(|step| (best, step))) else {
        return Err(TradeoffError::Budget { error: options.error, tried: describe(&candidates) });
    };
    let (modes, fidelity) = (best.modes.clone(), best.fidelity.clone());
    let Some(model) = search.model(&modes, &fidelity) else {
        return Err(TradeoffError::Budget { error: options.error, tried: describe(&candidates) });
    };
    let wanted = Configuration {
        modes: modes.clone(),
        fidelity,
        scalar: ScalarType::F64,
        integrator: best.integrator,
        step,
    };
    let left = options.error - model.error - best.step_error - reference.own_error();
    let (scalar, rounding) = scalar(study, &reference, model, &wanted, options, left);
    let truncations = motion::truncations(&reference, &whole, &states, &motion.modes, &modes);
    let parts = [model.error, best.step_error, rounding, reference.own_error()];
    Ok(Plan {
        configuration: Configuration { scalar, ..wanted },
        predicted_error: parts.iter().sum(),
        parts,
        operations: [best.operations, best.operations / step],
        motion,
        truncations,
        models: search.tried(),
        candidates: candidates.clone(),
        reference,
    })
}

fn survey(
    study: &Study,
    options: &PlanOptions,
    tolerance: f64,
) -> Result<(Reference, super::Variant, Vec<Vec<f64>>), TradeoffError> {
    Reference::survey(study, &options.quantities, ReferenceOptions { tolerance })
}

/// The number type, and what its rounding adds: single precision where it is allowed and its run stays close to that in double.
/// `left`: of the budget.
fn scalar(
    study: &Study,
    reference: &Reference,
    model: &model::Model,
    wanted: &Configuration,
    options: &PlanOptions,
    left: f64,
) -> (ScalarType, f64) {
    let allowed = |scalar| options.scalars.contains(&scalar);
    if !allowed(ScalarType::F32) {
        return (ScalarType::F64, 0.0);
    }
    let run = |scalar| steps::pilot(study, reference, model, &Configuration { scalar, ..wanted.clone() });
    let (Ok((double, _)), Ok((single, _))) = (run(ScalarType::F64), run(ScalarType::F32)) else {
        return (ScalarType::F64, 0.0);
    };
    let rounding = reference.distances(&double, &single).into_iter().fold(0.0, f64::max);
    if rounding <= left.min(ROUNDING_SHARE * options.error) || !allowed(ScalarType::F64) {
        (ScalarType::F32, rounding)
    } else {
        (ScalarType::F64, 0.0)
    }
}

fn describe(candidates: &[Candidate]) -> String {
    let lines = candidates.iter().map(|one| {
        let last = one.pilots.last().map_or("no run".to_owned(), Pilot::describe);
        format!("{} modes, {}, {}: {last}", one.modes, one.fidelity, one.integrator.name())
    });
    lines.collect::<Vec<_>>().join("; ")
}
