//! `ffrf plan`: a configuration of a scene for an error that is allowed.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::{Context, Result};
use ffrf_host::tradeoff::{
    Finding, INSTRUCTIONS_PER_OPERATION, Outcome, Pilot, Plan, PlanOptions, Reference, ReferenceOptions,
    Study, plan, run as run_one,
};

use crate::arguments;
use crate::trade_text::describe_reference;
use crate::{output, plan_on_target, plan_reasons, plan_within};

/// The tolerance of the reference of a measurement over that of the plan.
const TIGHTER: f64 = 0.1;

/// A plan, and what there is to say about it.
pub struct Planned {
    /// The plan.
    pub plan: Plan,
    /// What the command prints.
    pub text: String,
    /// The calls of the macros.
    pub macro_calls: String,
    /// The run of what is planned, if it was asked for.
    pub measured: Option<Outcome>,
}

/// Runs the command.
pub fn run(arguments: &arguments::Plan) -> Result<()> {
    let error = match (arguments.error, arguments.target) {
        (Some(error), _) => error,
        (None, Some(core)) => return plan_on_target::run(arguments, core),
        (None, None) => return plan_within::run(arguments),
    };
    let usual = PlanOptions::usual(error);
    let options = PlanOptions {
        quantities: arguments.quantity.clone(),
        integrators: arguments.integrator.clone().unwrap_or(usual.integrators),
        scalars: arguments.scalar.clone().unwrap_or(usual.scalars),
        ..usual
    };
    let planned = make(&arguments.scene, &options, arguments.measure)?;
    output::write(arguments.output.as_deref(), &planned.text)
}

/// Plans a scene; `measure`: and runs what is planned, against a reference that is more exact than that of the plan.
///
/// Errors: the scene, a quantity that it does not have, a budget that nothing keeps.
pub fn make(path: &Path, options: &PlanOptions, measure: bool) -> Result<Planned> {
    let in_scene = || format!("{}", path.display());
    let study = Study::read(path).with_context(in_scene)?;
    let plan = plan(&study, options).with_context(in_scene)?;
    let title = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let macro_calls = study.macro_calls(&title, &plan.configuration);
    let mut text = describe(&title, &plan, options.error, &macro_calls);
    let mut measured = None;
    if measure {
        let tolerance = TIGHTER * plan.reference.tolerance;
        let reference = Reference::compute(&study, &options.quantities, ReferenceOptions { tolerance })
            .with_context(in_scene)?;
        let variant = study.variant(plan.configuration.modes, &plan.configuration.fidelity)?;
        let outcome = run_one(&study, &variant, &reference, &plan.configuration);
        text.push_str(&describe_measured(&outcome, &plan, options.error, reference.own_error()));
        measured = Some(outcome);
    }
    Ok(Planned { plan, text, macro_calls, measured })
}

fn describe_measured(outcome: &Outcome, plan: &Plan, budget: f64, own_error: f64) -> String {
    match &outcome.finding {
        Finding::Failed(reason) => format!("\nmeasured\n  failed: {reason}\n"),
        Finding::Finished(measured) => {
            let error = measured.error();
            format!(
                "\nmeasured\n  error {error:.2e}: {:.2} of the budget, {:.2} of what was predicted; own error of its \
                 reference {own_error:.1e}\n  {:.3e} operations and {:.2e} s of this machine per simulated second\n",
                error / budget,
                error / plan.predicted_error,
                measured.operations_per_second(),
                measured.time
            )
        }
    }
}

fn describe(title: &str, plan: &Plan, budget: f64, macro_calls: &str) -> String {
    let one = &plan.configuration;
    let [model, steps, rounding, own] = plan.parts;
    let [per_step, per_second] = plan.operations;
    let mut text = format!(
        "plan for `{title}` with an error of at most {budget:e}\n\n\
         {} modes, {}, {}, {} with steps of {:.4e} s\n\
         predicted error {:.2e}: {model:.1e} of the model, {steps:.1e} of the steps, {rounding:.1e} of rounding, {own:.1e} of \
         the reference\n\
         predicted cost, of compiled code and estimated: {per_step:.3e} operations, about {:.1e} instructions, per step; \
         {per_second:.3e} operations per simulated second\n\n{}",
        one.modes,
        one.fidelity,
        one.scalar.name(),
        one.integrator.name(),
        one.step,
        plan.predicted_error,
        INSTRUCTIONS_PER_OPERATION * per_step,
        describe_reference(&plan.reference)
    );
    plan_reasons::describe(&mut text, plan, budget);
    text.push_str("\nintegrators: what the steps add, by pilot runs\n");
    for candidate in &plan.candidates {
        let end = match candidate.step {
            Some(step) => format!(
                "steps of {step:.3e} s, error {:.1e}, {:.3e} operations per second",
                candidate.step_error,
                candidate.operations / step
            ),
            None => "dropped: dearer than another, or no step keeps the budget".to_owned(),
        };
        let name = candidate.integrator.name();
        let _ = writeln!(text, "  {name} with {} modes, {}: {end}", candidate.modes, candidate.fidelity);
        for Pilot { step, error } in &candidate.pilots {
            let _ = match error {
                Ok(error) => writeln!(text, "    {step:.3e} s: {error:.1e}"),
                Err(reason) => writeln!(text, "    {step:.3e} s: {reason}"),
            };
        }
    }
    let _ = writeln!(text, "\n{}", macro_calls.trim_end());
    for (body, envelope) in &plan.motion.envelopes {
        let _ = writeln!(
            text,
            "// monitor of {body}: ffrf::Envelope {{ deformation: {:.3e}, speed: {:.3e}, spin: {:.3e}, bending: {:.4e} }}",
            envelope.deformation, envelope.speed, envelope.spin, envelope.bending
        );
    }
    text
}
