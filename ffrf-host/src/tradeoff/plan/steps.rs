//! How large a step an integrator may take: pilot runs from large steps down, and the order of the method from there on.

use ffrf_codegen::{Fidelity, ScalarType};
use ffrf_runtime::mechanism::Assembly;

use super::super::cost::evaluations_per_step;
use super::super::trajectory::trajectory;
use super::super::{Configuration, History, Reference, SceneModes, Study};
use super::model::Model;
use crate::scene::{Integrator, StepChoice};

/// One run of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Pilot {
    /// The step that was taken. Units: s.
    pub step: f64,
    /// The distance from the exactly integrated model, over the scale of the worst quantity, or why the run ended early.
    pub error: Result<f64, String>,
}

impl Pilot {
    /// In words.
    pub(super) fn describe(&self) -> String {
        match &self.error {
            Ok(error) => format!("error {error:.1e} with steps of {:.2e} s", self.step),
            Err(reason) => format!("{reason} with steps of {:.2e} s", self.step),
        }
    }
}

/// An integrator with a model, and the largest step that keeps the budget.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// Modes of the model.
    pub modes: SceneModes,
    /// Fidelity of the model.
    pub fidelity: Fidelity,
    /// The integrator.
    pub integrator: Integrator,
    /// The step; none if no step that was tried keeps the budget, or if it was dearer than another before that. Units: s.
    pub step: Option<f64>,
    /// Error of the steps that is expected.
    pub step_error: f64,
    /// Operations per step.
    pub operations: f64,
    /// The runs.
    pub pilots: Vec<Pilot>,
}

impl Candidate {
    /// Operations per simulated second, if there is a step.
    pub fn cost(&self) -> Option<f64> {
        self.step.map(|step| self.operations / step)
    }
}

/// Order of convergence.
fn order(integrator: Integrator) -> f64 {
    match integrator {
        Integrator::SymplecticEuler | Integrator::LinearlyImplicitEuler => 1.0,
        Integrator::LinearlyImplicit
        | Integrator::GeneralizedAlpha
        | Integrator::EnergyMomentum
        | Integrator::Exponential => 2.0,
        Integrator::Rk4 => 4.0,
        Integrator::Dopri5 | Integrator::Radau5 => 5.0,
        Integrator::Radau7 => 7.0,
    }
}

/// An explicit step over the largest stable one of the classical Runge-Kutta method, where a search begins.
const STABLE: f64 = 0.95;
/// Steps go down by this much while nothing is known of their error.
const COARSE_FACTOR: f64 = 4.0;
/// A step is aimed at this share of what the steps may err, for the order is never exact.
const AIM: f64 = 0.7;
/// The order is relied on for steps down to this share of the last pilot's.
const REACH: f64 = 0.2;
/// An observed order this much off, relative, is not yet the method's own.
const ASYMPTOTIC: f64 = 0.3;
/// Most runs of a search.
const RUNS: usize = 12;
/// A search ends when its next step would cost this much more than the cheapest found.
const DEARER: f64 = 1.2;

/// The largest step with which `integrator` keeps the budget `error` with a model. `cheapest`: cost found so far.
pub(super) fn candidate(
    study: &Study,
    reference: &Reference,
    model: &Model,
    integrator: Integrator,
    error: f64,
    cheapest: f64,
) -> Candidate {
    let mut found = Candidate {
        modes: model.modes.clone(),
        fidelity: model.fidelity.clone(),
        integrator,
        step: None,
        step_error: 0.0,
        operations: model.variant.cost.operations * evaluations_per_step(integrator, 1.0),
        pilots: Vec::new(),
    };
    let left = error - model.error - reference.own_error();
    if left <= 0.0 {
        return found;
    }
    let interval = study.interval();
    let fits = |step: f64| interval / (interval / step - 1e-9).ceil().max(1.0);
    let stable = model.variant.scene.mechanism.largest_stable_step().filter(|_| integrator.is_explicit());
    let order = order(integrator);
    let mut step = fits(stable.map_or(interval, |stable| interval.min(STABLE * stable)));
    for _ in 0..RUNS {
        if found.operations / step > DEARER * cheapest {
            return found;
        }
        let configuration = Configuration {
            modes: model.modes.clone(),
            fidelity: model.fidelity.clone(),
            scalar: ScalarType::F64,
            integrator,
            step,
        };
        let ran = pilot(study, reference, model, &configuration);
        let error = ran.map(|(history, evaluations)| {
            found.operations = model.variant.cost.operations * evaluations;
            reference.distances(&model.history, &history).into_iter().fold(0.0, f64::max)
        });
        found.pilots.push(Pilot { step, error: error.clone() });
        let Ok(error) = error else {
            step = fits(step / COARSE_FACTOR);
            continue;
        };
        if error <= left {
            // the last step was too coarse, or there is no larger one
            let before = found.pilots.iter().rev().nth(1).map(|pilot| pilot.step);
            let shown = observed_order(&found.pilots).is_some_and(|p| (p / order - 1.0).abs() < ASYMPTOTIC);
            let larger = step * (AIM * left / error).powf(1.0 / order);
            let chosen = match before {
                Some(before) if shown && larger > step => fits(larger.min(before)),
                _ => step,
            };
            found.step_error = error * (chosen / step).powf(order);
            found.step = Some(chosen);
            return found;
        }
        let wanted = step * (AIM * left / error).powf(1.0 / order);
        if wanted >= REACH * step
            && observed_order(&found.pilots).is_some_and(|p| (p / order - 1.0).abs() < ASYMPTOTIC)
        {
            let chosen = fits(wanted);
            found.step_error = error * (chosen / step).powf(order);
            found.step = Some(chosen);
            return found;
        }
        step = fits(wanted.clamp(step / COARSE_FACTOR, 0.5 * step));
    }
    found
}

/// The order that the last two pilots show.
fn observed_order(pilots: &[Pilot]) -> Option<f64> {
    let [.., before, last] = pilots else { return None };
    let (Ok(coarse), Ok(fine)) = (&before.error, &last.error) else { return None };
    Some((coarse / fine).ln() / (before.step / last.step).ln())
}

/// Runs a configuration: the channels over time, and evaluations per step.
pub(super) fn pilot(
    study: &Study,
    reference: &Reference,
    model: &Model,
    configuration: &Configuration,
) -> Result<(History, f64), String> {
    let Configuration { integrator, step, scalar, .. } = configuration;
    let settings =
        study.settings_of(*integrator, StepChoice::Fixed(*step)).map_err(|error| error.to_string())?;
    let Reference { channels, times, .. } = reference;
    let ran = match scalar {
        ScalarType::F32 => trajectory::<f32>(&model.variant, &settings, channels, times),
        ScalarType::F64 | ScalarType::Generic => {
            trajectory::<f64>(&model.variant, &settings, channels, times)
        }
    };
    let (history, steps) = ran.map_err(|(time, error)| format!("t = {time:.3e} s: {error}"))?;
    let iterations = steps.iterations as f64 / steps.accepted.max(1) as f64;
    Ok((history, evaluations_per_step(*integrator, iterations)))
}
