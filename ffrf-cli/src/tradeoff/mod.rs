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

use anyhow::{Context, Result};
use ffrf_host::tradeoff::{Axes, Done, Finding, Outcome, Study};

use crate::arguments::Tradeoff;
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
    };
    let study = question.study()?;
    let axes = axes(&study, arguments);
    // before anything is computed
    study.check_held(&axes.fidelities).with_context(|| arguments.scene.display().to_string())?;
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

/// How many runs go at a time where nobody says it.
pub fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// The axes that are given, and for the others what is usual.
fn axes(study: &Study, arguments: &Tradeoff) -> Axes {
    let usual = Axes::usual(study);
    Axes {
        modes: arguments.modes.clone().unwrap_or(usual.modes),
        fidelities: arguments.fidelity.clone().unwrap_or(usual.fidelities),
        scalars: arguments.scalar.clone().unwrap_or(usual.scalars),
        integrators: arguments.integrator.clone().unwrap_or(usual.integrators),
        steps: arguments.step.clone().unwrap_or(usual.steps),
    }
}
