//! `ffrf plan`: a configuration of a scene for an error that is allowed.

use std::fmt::Write as _;

use anyhow::{Context, Result};
use ffrf_codegen::ScalarType;
use ffrf_host::scene::{Integrator, StepChoice};
use ffrf_host::tradeoff::{
    Finding, Pilot, Plan, PlanOptions, PlanWithin, Reference, ReferenceOptions, StepBudget, Study, plan,
    plan_within, run as run_one,
};

use crate::arguments;
use crate::output;
use crate::trade_text::{INSTRUCTIONS_PER_OPERATION, describe_reference};

/// The tolerance of the reference of a measurement over that of the plan.
const TIGHTER: f64 = 0.1;

/// Runs the command.
pub fn run(arguments: &arguments::Plan) -> Result<()> {
    let path = &arguments.scene;
    let in_scene = || format!("{}", path.display());
    let study = Study::read(path).with_context(in_scene)?;
    let title = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let quantities = arguments.quantity.clone();
    let integrators = arguments.integrator.clone().unwrap_or_else(|| INTEGRATORS.to_vec());
    let scalars = arguments.scalar.clone().unwrap_or_else(|| vec![ScalarType::F64, ScalarType::F32]);
    let mut text;
    let (configuration, predicted, budget, tolerance);
    match (arguments.error, arguments.time_per_step.zip(arguments.operations_per_second)) {
        (Some(error), _) => {
            let options = PlanOptions { error, quantities: quantities.clone(), integrators, scalars };
            let found = plan(&study, &options).with_context(in_scene)?;
            text = describe(&study, &title, &found, error);
            (predicted, budget, tolerance) = (found.predicted_error, error, found.reference.tolerance);
            configuration = found.configuration;
        }
        (None, Some((time, rate))) => {
            let step = match (arguments.step, study.settings().step) {
                (Some(step), _) | (None, StepChoice::Fixed(step)) => step,
                (None, StepChoice::Tolerance(_)) => {
                    anyhow::bail!("{}: --step is needed: the step of the scene is free", path.display())
                }
            };
            let operations = time * rate;
            let budget_of_step =
                StepBudget { step, operations, quantities: quantities.clone(), integrators, scalars };
            let found = plan_within(&study, &budget_of_step).with_context(in_scene)?;
            text = describe_within(&study, &title, &found, &budget_of_step, [time, rate]);
            (predicted, budget, tolerance) = (found.error, found.error, found.reference.tolerance);
            configuration = found.best.configuration;
        }
        (None, None) => anyhow::bail!("expected --error, or --time-per-step with --operations-per-second"),
    }
    if arguments.measure {
        let tolerance = TIGHTER * tolerance;
        let reference =
            Reference::compute(&study, &quantities, ReferenceOptions { tolerance }).with_context(in_scene)?;
        let variant = study.variant(configuration.modes, &configuration.fidelity)?;
        let outcome = run_one(&study, &variant, &reference, &configuration);
        text.push_str("\nmeasured\n");
        match outcome.finding {
            Finding::Failed(reason) => {
                let _ = writeln!(text, "  failed: {reason}");
            }
            Finding::Finished(measured) => {
                let error = measured.error();
                let _ = writeln!(
                    text,
                    "  error {error:.2e}: {:.2} of the budget, {:.2} of what was predicted; own error of its reference {:.1e}\n  \
                     {:.3e} operations and {:.2e} s of this machine per simulated second",
                    error / budget,
                    error / predicted,
                    reference.own_error(),
                    measured.operations_per_second(),
                    measured.time
                );
            }
        }
    }
    output::write(arguments.output.as_deref(), &text)
}

/// What was chosen for a time per step, and everything that there was time for.
fn describe_within(
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
        budget.operations,
        one.modes,
        one.fidelity,
        one.scalar.name(),
        one.integrator.name(),
        found.error,
        found.best.operations,
        INSTRUCTIONS_PER_OPERATION * found.best.operations,
        100.0 * found.best.operations / budget.operations,
        describe_reference(&found.reference)
    );
    text.push_str(
        "\nfor each kind of model the most modes that there is time for, and that the step is stable with\n",
    );
    for one in &found.tried {
        let _ = writeln!(text, "  {}", one.describe());
    }
    let _ = writeln!(text, "\n{}", study.macro_calls(title, one).trim_end());
    text
}

/// One method for what is not stiff and its fellow of higher order, and two that take stiff modes implicitly.
const INTEGRATORS: [Integrator; 4] =
    [Integrator::Rk4, Integrator::Dopri5, Integrator::LinearlyImplicit, Integrator::GeneralizedAlpha];

fn describe(study: &Study, title: &str, plan: &Plan, budget: f64) -> String {
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
    describe_models(&mut text, plan);
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
    let _ = writeln!(text, "\n{}", study.macro_calls(title, one).trim_end());
    for (body, envelope) in &plan.motion.envelopes {
        let _ = writeln!(
            text,
            "// monitor of {body}: ffrf::Envelope {{ deformation: {:.3e}, speed: {:.3e}, spin: {:.3e}, bending: {:.4e} }}",
            envelope.deformation, envelope.speed, envelope.spin, envelope.bending
        );
    }
    text
}

/// Modes and terms, what they do in the scene and why they are kept or dropped.
fn describe_models(text: &mut String, plan: &Plan) {
    if !plan.motion.modes.is_empty() {
        text.push_str("\nmodes: what they do in the motion of the whole model\n");
    }
    for mode in &plan.motion.modes {
        let verdict = if mode.mode <= plan.configuration.modes { "kept" } else { "dropped" };
        let _ = writeln!(
            text,
            "  {} {}: {:.4} Hz, moves markers by up to {:.1e} m, {:.1e} of the elastic energy: {verdict}",
            mode.body, mode.mode, mode.frequency, mode.displacement, mode.energy_share
        );
    }
    if !plan.motion.terms.is_empty() {
        text.push_str("\nterms of the kinetic energy: their largest share of it in the scene\n");
    }
    for term in &plan.motion.terms {
        let verdict = match (plan.configuration.modes, plan.configuration.fidelity.keeps(term.term)) {
            (0, _) => "kept as far as a rigid body has it",
            (_, true) => "kept",
            (_, false) => "dropped",
        };
        let _ = writeln!(text, "  {} {}: {:.1e}: {verdict}", term.body, term.term.name(), term.share);
    }
    text.push_str("\nmodels: their error with exact steps\n");
    for choice in &plan.models {
        let _ = writeln!(text, "  {} modes, {}: {:.2e}", choice.modes, choice.fidelity, choice.error);
    }
}
