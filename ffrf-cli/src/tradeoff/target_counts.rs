//! What a step of each configuration takes of a core: counted once for a program, which all its steps have in common.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use anyhow::{Context, Result, bail};
use ffrf_host::tradeoff::{Configuration, Outcome, Study};
use serde::{Deserialize, Serialize};

use super::row::modes_width;
use crate::arguments::Core;
use crate::budget::{StepOnTarget, Workshop, configuration_on_target, of_fixed_cost};
use crate::report::chain;

/// What was counted, by core and program; see [`Configuration::program`].
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct TargetCounts(BTreeMap<String, BTreeMap<String, TargetCount>>);

/// What came of one program.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TargetCount {
    /// It ran.
    Counted(StepOnTarget),
    /// It could not be built or run, and why.
    Failed(String),
}

impl TargetCounts {
    /// The cores that something was counted on.
    pub fn cores(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// What a configuration takes of a core.
    pub fn of(&self, core: &str, one: &Configuration) -> Option<&TargetCount> {
        self.0.get(core)?.get(&one.program())
    }

    /// The same where it was counted.
    pub fn cost(&self, core: &str, one: &Configuration) -> Option<&StepOnTarget> {
        match self.of(core, one)? {
            TargetCount::Counted(cost) => Some(cost),
            TargetCount::Failed(_) => None,
        }
    }

    /// Takes note of what came of a program.
    pub fn insert(&mut self, core: &str, one: &Configuration, count: TargetCount) {
        self.0.entry(core.to_owned()).or_default().insert(one.program(), count);
    }
}

/// What was counted on a core as a table for people, the cheapest first, and what could not be.
pub fn lines<'a>(core: &str, counts: &TargetCounts, outcomes: impl Iterator<Item = &'a Outcome>) -> String {
    let mut seen = BTreeSet::new();
    let programs: Vec<&Configuration> = outcomes
        .map(|outcome| &outcome.configuration)
        .filter(|one| counts.of(core, one).is_some() && seen.insert(one.program()))
        .collect();
    let wide = modes_width(programs.iter().copied());
    let mut text = format!(
        "\n{core}: a step as counted in the emulator, whatever its length; data is constants in tables, model and state\n\
         {:>wide$} {:<14} {:<6} {:<24} {:>12} {:>8} {:>8} {:>8} {:>8}\n",
        "modes", "fidelity", "scalar", "integrator", "instructions", "code/B", "data/B", "stack/B", "at most"
    );
    let name = |one: &Configuration| {
        let (fidelity, scalar, integrator) = (one.fidelity.to_string(), one.scalar, one.integrator);
        format!("{:>wide$} {fidelity:<14} {:<6} {:<24}", one.modes, scalar.name(), integrator.name())
    };
    let mut counted: Vec<(&Configuration, &StepOnTarget)> =
        programs.iter().filter_map(|one| Some((*one, counts.cost(core, one)?))).collect();
    counted.sort_by_key(|(_, cost)| cost.instructions);
    for (one, cost) in counted {
        let bound = cost.stack_bound.map_or("unknown".to_owned(), |bound| bound.to_string());
        let (data, StepOnTarget { instructions, code, stack, .. }) = (cost.data(), cost);
        let _ = writeln!(text, "{} {instructions:>12} {code:>8} {data:>8} {stack:>8} {bound:>8}", name(one));
    }
    for one in programs {
        if let Some(TargetCount::Failed(reason)) = counts.of(core, one) {
            let _ = writeln!(text, "{} not counted: {}", name(one), ffrf_model::printable(reason));
        }
    }
    text
}

/// The programs of outcomes that reached their end: for each the configuration of the shortest step, with which its motion is
/// the calmest. Integrators whose work varies have none.
fn programs(outcomes: &[Outcome]) -> Vec<Configuration> {
    let mut found: BTreeMap<String, Configuration> = BTreeMap::new();
    for outcome in outcomes.iter().filter(|outcome| outcome.measured().is_some()) {
        let one = &outcome.configuration;
        if of_fixed_cost(one.integrator).is_none() {
            continue;
        }
        let known = found.entry(one.program()).or_insert_with(|| one.clone());
        if one.step < known.step {
            *known = one.clone();
        }
    }
    let mut programs: Vec<Configuration> = found.into_values().collect();
    programs.sort_by(|a, b| b.expected_effort().total_cmp(&a.expected_effort()));
    programs
}

/// Counts what `counts` does not have, which `keep` gets with each count as soon as it is there. `told`: how many programs are
/// done, of how many.
///
/// Errors: the first program of all cannot be built or run, as without the tools for the target; a count cannot be kept.
pub fn count(
    study: &Study,
    outcomes: &[Outcome],
    (core, workshop): (Core, &Workshop),
    mut counts: TargetCounts,
    keep: &mut dyn FnMut(&TargetCounts) -> Result<()>,
    told: &mut dyn FnMut(usize, usize),
) -> Result<()> {
    let programs = programs(outcomes);
    if programs.is_empty() {
        bail!(
            "{}: no run with an integrator of fixed cost, rk4 or linearly_implicit, reached its end",
            core.name()
        );
    }
    let mut is_proven = programs.iter().any(|one| counts.cost(core.name(), one).is_some());
    for (done, one) in programs.iter().enumerate() {
        told(done, programs.len());
        if counts.cost(core.name(), one).is_some() {
            continue;
        }
        let count = match configuration_on_target(study, one, core, workshop) {
            Ok(step) => TargetCount::Counted(step),
            Err(error) if !is_proven => return Err(error).with_context(|| core.name().to_owned()),
            Err(error) => TargetCount::Failed(chain(&error)),
        };
        is_proven = true;
        counts.insert(core.name(), one, count);
        keep(&counts)?;
    }
    Ok(())
}
