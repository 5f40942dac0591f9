//! `ffrf plan --time-per-step`: a configuration of a scene for the time that a step may take.

use std::fmt::Write as _;

use anyhow::{Context, Result, bail};
use ffrf_host::scene::StepChoice;
use ffrf_host::tradeoff::{
    Finding, INSTRUCTIONS_PER_OPERATION, Operations, PlanOptions, PlanWithin, Reference, ReferenceOptions,
    StepBudget, Study, plan_within, run as run_one,
};

use crate::trade_text::describe_reference;
use crate::{arguments, output};

/// The tolerance of the reference of a measurement over that of the plan.
const TIGHTER: f64 = 0.1;

/// Runs the command without `--error`.
pub fn run(arguments: &arguments::Plan) -> Result<()> {
    let path = &arguments.scene;
    let in_scene = || format!("{}", path.display());
    let Some((time, rate)) = arguments.time_per_step.zip(arguments.operations_per_second) else {
        bail!("expected --error, or --time-per-step with --operations-per-second");
    };
    let study = Study::read(path).with_context(in_scene)?;
    let step = match (arguments.step, study.settings().step) {
        (Some(step), _) | (None, StepChoice::Fixed(step)) => step,
        (None, StepChoice::Tolerance(_)) => {
            bail!("{}: --step is needed: the step of the scene is free", path.display())
        }
    };
    // the error is no budget here
    let usual = PlanOptions::usual(f64::INFINITY);
    let budget = StepBudget {
        step,
        operations: Operations { double: time * rate, single: time * rate },
        divisions: vec![1],
        quantities: arguments.quantity.clone(),
        integrators: arguments.integrator.clone().unwrap_or(usual.integrators),
        scalars: arguments.scalar.clone().unwrap_or(usual.scalars),
    };
    let found = plan_within(&study, &budget).with_context(in_scene)?;
    let title = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let mut text = describe(&study, &title, &found, &budget, [time, rate]);
    if arguments.measure {
        text.push_str(&measured(&study, &found, &budget).with_context(in_scene)?);
    }
    output::write(arguments.output.as_deref(), &text)
}

/// Runs what was chosen, against a reference that is more exact than that of the plan.
pub(crate) fn measured(study: &Study, found: &PlanWithin, budget: &StepBudget) -> Result<String> {
    // the times at which the plan compares
    let sampled = study.in_steps_of(budget.step);
    let study = sampled.as_ref().unwrap_or(study);
    let tolerance = TIGHTER * found.reference.tolerance;
    let reference = Reference::compute(study, &budget.quantities, ReferenceOptions { tolerance })?;
    let one = &found.best.configuration;
    let variant = study.variant(one.modes, &one.fidelity)?;
    Ok(match run_one(study, &variant, &reference, one).finding {
        Finding::Failed(reason) => format!("\nmeasured\n  failed: {reason}\n"),
        Finding::Finished(measured) => format!(
            "\nmeasured\n  error {:.2e}: {:.2} of what was planned; own error of its reference {:.1e}\n",
            measured.error(),
            measured.error() / found.error,
            reference.own_error()
        ),
    })
}

/// What was chosen, and everything that there was time for.
fn describe(
    study: &Study,
    title: &str,
    found: &PlanWithin,
    budget: &StepBudget,
    [time, rate]: [f64; 2],
) -> String {
    let one = &found.best.configuration;
    let mut text = format!(
        "plan for `{title}` with steps of {:e} s that take at most {time:e} s at {rate:.3e} operations per second: {:.3e} \
         operations\n\n{} modes, {}, {}, {}\nerror {:.2e} in a run of the scene\ncost, of compiled code and estimated: {:.3e} \
         operations, about {:.1e} instructions, per step: {:.0} % of what there is time for\n\n{}",
        budget.step,
        budget.operations.double,
        one.modes,
        one.fidelity,
        one.scalar.name(),
        one.integrator.name(),
        found.error,
        found.best.operations,
        INSTRUCTIONS_PER_OPERATION * found.best.operations,
        100.0 * found.best.share(budget),
        describe_reference(&found.reference)
    );
    text.push_str(&tried_and_calls(study, title, found));
    text
}

/// Everything that was run, and the calls of the macros that make what was chosen.
pub(crate) fn tried_and_calls(study: &Study, title: &str, found: &PlanWithin) -> String {
    let mut text = String::from(
        "\nfor each kind of model the most modes that there is time for, and that the step is stable with\n",
    );
    for one in &found.tried {
        let _ = writeln!(text, "  {}", one.describe());
    }
    let _ = writeln!(text, "\n{}", study.macro_calls(title, &found.best.configuration).trim_end());
    text
}
