//! `ffrf tradeoff`: a scene in many configurations, their errors and their cost.

mod asked;
mod page;
mod report;
mod row;
mod saved;
mod store;
mod sweep;
mod table;
mod target_counts;

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use ffrf_host::tradeoff::{Axes, Done, Finding, Outcome, Study};

use crate::arguments::{NamedModel, Tradeoff};
use crate::budget::Workshop;
use crate::output;
use crate::progress::ShareTeller;

pub use crate::arguments::{parse_fidelity, parse_integrator, parse_scalar};
pub use asked::Asked;
pub use saved::{outcome_from_json, outcome_to_json};
pub use sweep::{Measure, Question, Sweep};

/// Runs the command.
pub fn run(arguments: &Tradeoff) -> Result<()> {
    let question = Question {
        scene: arguments.scene.clone(),
        quantities: arguments.quantity.clone(),
        reference_tolerance: arguments.reference_tolerance,
        reference_models: reference_models(&arguments.reference_model)?,
    };
    let study = question.study()?;
    let in_scene = || arguments.scene.display().to_string();
    let axes = axes(&study, arguments).with_context(in_scene)?;
    // before anything is computed
    study.check_held(&axes.fidelities).with_context(in_scene)?;
    let configurations = axes.configurations();
    let computing = || output::complain("the reference is computed\n");
    let sweep = Sweep::of(study, question, &arguments.output, computing)?;
    let known = sweep.known(&configurations)?;
    let teller = ShareTeller::new("tradeoff");
    let threads = arguments.threads.unwrap_or_else(cores);
    let outcomes = sweep.run(&configurations, &known, threads, &mut |Done { done, total }| {
        teller.tell(done as f64 / total as f64, &format!("{done} of {total} runs"));
        Ok(())
    });
    teller.end();
    let outcomes = outcomes?;
    let counted = count(&sweep, &outcomes, arguments);
    let page = sweep.write(&outcomes)?;
    let failed = outcomes.iter().filter(|outcome| matches!(outcome.finding, Finding::Failed(_))).count();
    output::say(&format!(
        "{} runs, {} of them here before, {failed} failed\n{}written: {}\n",
        outcomes.len(),
        known.len(),
        crate::trade_text::describe_reference(&sweep.measure().reference),
        page.display()
    ))?;
    // what was swept is written all the same
    counted
}

/// Counts on the cores that are asked for.
fn count(sweep: &Sweep, outcomes: &[Outcome], arguments: &Tradeoff) -> Result<()> {
    let workshop = Workshop { sources: arguments.sources.clone(), folder: arguments.folder.clone() };
    for core in &arguments.target {
        let teller = ShareTeller::new("programs");
        let counted = sweep.count(outcomes, *core, &workshop, &mut |done, total| {
            teller.tell(done as f64 / total as f64, &format!("{done} of {total} on {}", core.name()));
        });
        teller.end();
        counted?;
    }
    Ok(())
}

/// The models of the reference by the names of their bodies. Errors: a body is named twice, a file is not there.
fn reference_models(named: &[NamedModel]) -> Result<BTreeMap<String, PathBuf>> {
    let mut models = BTreeMap::new();
    for NamedModel { body, file } in named {
        let path = fs::canonicalize(file).with_context(|| file.display().to_string())?;
        if models.insert(body.clone(), path).is_some() {
            bail!("--reference-model: two models of body `{body}`");
        }
    }
    Ok(models)
}

/// How many runs go at a time where nobody says it.
pub fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// The axes that are given, and for the others what is usual. Errors: modes of a body that is not there, or is rigid.
fn axes(study: &Study, arguments: &Tradeoff) -> Result<Axes> {
    let usual = Axes::usual(study);
    Ok(Axes {
        modes: if arguments.modes.is_empty() { usual.modes } else { study.mode_axis(&arguments.modes)? },
        fidelities: arguments.fidelity.clone().unwrap_or(usual.fidelities),
        scalars: arguments.scalar.clone().unwrap_or(usual.scalars),
        integrators: arguments.integrator.clone().unwrap_or(usual.integrators),
        steps: arguments.step.clone().unwrap_or(usual.steps),
    })
}
