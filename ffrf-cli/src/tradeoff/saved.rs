//! Reference and outcomes as text, to their last bit: in the folder of a sweep, and on the way between processes.

use anyhow::{Context, Error, Result};
use ffrf_codegen::Fidelity;
use ffrf_host::tradeoff::{
    Channel, Configuration, Finding, History, Measured, Modes, Outcome, Reference, StaticCost,
};
use serde::{Deserialize, Serialize};

use crate::arguments::{parse_integrator, parse_scalar};

/// The text of a reference.
pub fn reference_to_json(reference: &Reference) -> Result<String> {
    let saved = SavedReference {
        channels: reference.channels.iter().map(|channel| channel.name.clone()).collect(),
        tolerance: reference.tolerance,
        steps: reference.steps,
        modes: reference.modes,
        fidelity: reference.fidelity.to_string(),
        scales: reference.scales.clone(),
        own_errors: reference.own_errors.clone(),
        times: reference.times.clone(),
        values: reference.history.values.clone(),
    };
    Ok(serde_json::to_string(&saved)?)
}

/// The reference of a text. `channels`: those of the scene and quantities that it is of.
pub fn reference_from_json(text: &str, channels: Vec<Channel>) -> Result<Reference> {
    let saved: SavedReference = serde_json::from_str(text)?;
    let fidelity = saved.fidelity.parse()?;
    Ok(Reference {
        channels,
        times: saved.times,
        history: History { values: saved.values },
        scales: saved.scales,
        own_errors: saved.own_errors,
        tolerance: saved.tolerance,
        steps: saved.steps,
        modes: saved.modes,
        fidelity,
    })
}

/// The text of an outcome, without a line's end.
pub fn outcome_to_json(outcome: &Outcome) -> serde_json::Result<String> {
    let Configuration { modes, fidelity, scalar, integrator, step } = &outcome.configuration;
    serde_json::to_string(&SavedRun {
        modes: modes.into(),
        fidelity: fidelity.to_string(),
        scalar: scalar.name().to_owned(),
        integrator: integrator.name().to_owned(),
        step: *step,
        finding: SavedFinding::from(&outcome.finding),
    })
}

/// The outcome of a text.
pub fn outcome_from_json(text: &str) -> Result<Outcome> {
    let saved: SavedRun = serde_json::from_str(text).context("an outcome of a sweep")?;
    let scalar = parse_scalar(&saved.scalar).map_err(Error::msg)?;
    let integrator = parse_integrator(&saved.integrator).map_err(Error::msg)?;
    let fidelity = saved.fidelity.parse()?;
    let configuration =
        Configuration { modes: saved.modes.into(), fidelity, scalar, integrator, step: saved.step };
    Ok(Outcome { configuration, finding: saved.finding.into() })
}

#[derive(Serialize, Deserialize)]
struct SavedReference {
    channels: Vec<String>,
    tolerance: f64,
    steps: u64,
    modes: usize,
    #[serde(default = "every_term")]
    fidelity: String,
    scales: Vec<f64>,
    own_errors: Vec<f64>,
    times: Vec<f64>,
    values: Vec<Vec<f64>>,
}

/// What references had that do not say it.
fn every_term() -> String {
    Fidelity::Full.to_string()
}

#[derive(Serialize, Deserialize)]
struct SavedRun {
    modes: SavedModes,
    fidelity: String,
    scalar: String,
    integrator: String,
    step: f64,
    finding: SavedFinding,
}

#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum SavedModes {
    First(usize),
    Listed(Vec<usize>),
}

impl From<&Modes> for SavedModes {
    fn from(modes: &Modes) -> Self {
        match modes.list() {
            None => Self::First(modes.count()),
            Some(list) => Self::Listed(list.to_vec()),
        }
    }
}

impl From<SavedModes> for Modes {
    fn from(saved: SavedModes) -> Self {
        match saved {
            SavedModes::First(count) => Self::first(count),
            SavedModes::Listed(list) => Self::listed(list),
        }
    }
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum SavedFinding {
    Finished {
        step: f64,
        steps: u64,
        evaluations: f64,
        errors: Vec<f64>,
        operations: f64,
        constants: usize,
        stack_numbers: usize,
        time: f64,
    },
    Failed(String),
}

impl From<&Finding> for SavedFinding {
    fn from(finding: &Finding) -> Self {
        match finding {
            Finding::Failed(reason) => Self::Failed(reason.clone()),
            Finding::Finished(measured) => Self::Finished {
                step: measured.step,
                steps: measured.steps,
                evaluations: measured.evaluations,
                errors: measured.errors.clone(),
                operations: measured.cost.operations,
                constants: measured.cost.constants,
                stack_numbers: measured.cost.stack_numbers,
                time: measured.time,
            },
        }
    }
}

impl From<SavedFinding> for Finding {
    fn from(saved: SavedFinding) -> Self {
        match saved {
            SavedFinding::Failed(reason) => Self::Failed(reason),
            SavedFinding::Finished {
                step,
                steps,
                evaluations,
                errors,
                operations,
                constants,
                stack_numbers,
                time,
            } => Self::Finished(Measured {
                step,
                steps,
                evaluations,
                errors,
                cost: StaticCost { operations, constants, stack_numbers },
                time,
            }),
        }
    }
}
