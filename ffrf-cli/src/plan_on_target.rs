//! `ffrf plan --target`: a configuration of a scene for the tick of a controller on a core, in instructions that are predicted
//! and, with `--measure`, counted in the emulator.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use anyhow::{Context, Result, bail};
use ffrf_codegen::{DEFAULT_LAYOUT_TOLERANCE, ScalarType};
use ffrf_host::scene::Integrator;
use ffrf_host::tradeoff::{
    Affordable, Operations, PlanOptions, PlanWithin, StepBudget, Study, plan_again_within, plan_within,
};

use crate::arguments::{self, Core, OnTarget, TargetIntegrator};
use crate::budget::{MechanismProgram, StepOnTarget, Workshop, step_on_target};
use crate::output;
use crate::plan_within::{measured, tried_and_calls};
use crate::report::chain;
use crate::trade_text::describe_reference;

/// Into how many steps a tick is divided: an explicit step may be stable or exact enough only so.
const DIVISIONS: [usize; 3] = [1, 2, 4];
/// Most plans, each with what the programs before it took.
const ROUNDS: usize = 4;

impl Core {
    /// Instructions of a step over its operations as a plan counts them, about.
    ///
    /// Counted on 2026-11-30 of steps of `models/scenes/slider_crank.toml`: 14.4 and 390 on a Cortex-M4F in single and double
    /// precision, which is software there, 11.9 and 16.6 on a Cortex-M7. Loads and stores are instructions of their own.
    fn instructions_per_operation(self, scalar: ScalarType) -> f64 {
        match (self, scalar) {
            (Self::CortexM4F, ScalarType::F32) => 15.0,
            (Self::CortexM4F, _) => 400.0,
            (Self::CortexM7, ScalarType::F32) => 12.0,
            (Self::CortexM7, _) => 17.0,
        }
    }
}

/// What a target allows, and what is known of its instructions.
struct Target {
    core: Core,
    /// Units: Hz.
    clock: f64,
    /// Instructions that a tick has time for.
    allowed: f64,
    /// Instructions per operation in double and single precision, and whether they come from a count.
    double: (f64, bool),
    single: (f64, bool),
}

impl Target {
    fn new(core: Core, options: &OnTarget) -> Self {
        let clock = options.clock.unwrap_or(1e6 * core.clock().1);
        let allowed = clock * options.tick * options.share / options.cycles_per_instruction;
        let usual = |scalar| (core.instructions_per_operation(scalar), false);
        Self { core, clock, allowed, double: usual(ScalarType::F64), single: usual(ScalarType::F32) }
    }

    fn operations(&self) -> Operations {
        Operations { double: self.allowed / self.double.0, single: self.allowed / self.single.0 }
    }

    fn per_operation(&self, scalar: ScalarType) -> (f64, bool) {
        if scalar == ScalarType::F32 { self.single } else { self.double }
    }

    fn learn(&mut self, scalar: ScalarType, per_operation: f64) {
        let known = if scalar == ScalarType::F32 { &mut self.single } else { &mut self.double };
        *known = (per_operation, true);
    }
}

/// A configuration whose program ran in the emulator.
struct Counted {
    found: PlanWithin,
    /// What was predicted for a tick before.
    predicted: f64,
    step: StepOnTarget,
}

impl Counted {
    /// Instructions of a tick.
    fn instructions(&self) -> f64 {
        self.step.instructions as f64 * self.found.best.divisions as f64
    }
}

/// Runs the command with `--target`.
pub fn run(arguments: &arguments::Plan, core: Core) -> Result<()> {
    let (path, options) = (&arguments.scene, &arguments.on_target);
    let in_scene = || format!("{}", path.display());
    let integrators =
        arguments.integrator.clone().unwrap_or(vec![Integrator::Rk4, Integrator::LinearlyImplicit]);
    for integrator in &integrators {
        if on_target(*integrator).is_none() {
            bail!(
                "--integrator {}: the work of its step varies; expected rk4 or linearly_implicit with --target",
                integrator.name()
            );
        }
    }
    let study = Study::read(path).with_context(in_scene)?;
    let mut target = Target::new(core, options);
    let mut budget = StepBudget {
        step: options.tick,
        operations: target.operations(),
        divisions: DIVISIONS.to_vec(),
        quantities: arguments.quantity.clone(),
        integrators,
        scalars: arguments.scalar.clone().unwrap_or(PlanOptions::usual(f64::INFINITY).scalars),
    };
    let mut found = plan_within(&study, &budget).with_context(in_scene)?;
    let mut counted: Vec<Counted> = Vec::new();
    let mut without_count = None;
    if arguments.measure {
        let workshop = Workshop { sources: options.sources.clone(), folder: options.folder.clone() };
        let mut known = BTreeSet::new();
        for _ in 0..ROUNDS {
            let one = &found.best;
            if !known.insert(one.configuration.key()) {
                break;
            }
            let (per_operation, _) = target.per_operation(one.configuration.scalar);
            let predicted = per_operation * one.operations;
            let step = match count(&study, one, core, &workshop) {
                Ok(step) => step,
                Err(error) => {
                    without_count = Some(chain(&error));
                    break;
                }
            };
            let one = Counted { found: found.clone(), predicted, step };
            target.learn(one.found.best.configuration.scalar, one.instructions() / one.found.best.operations);
            counted.push(one);
            budget.operations = target.operations();
            match plan_again_within(&study, &found, &budget) {
                Ok(next) => found = next,
                // what was counted may fit all the same
                Err(_) if counted.iter().any(|one| one.instructions() <= target.allowed) => break,
                Err(error) => {
                    let counts: String = counted.iter().map(|one| describe_count(one, &target)).collect();
                    return Err(error)
                        .with_context(in_scene)
                        .with_context(|| format!("too dear, as counted\n{}", counts.trim_end()));
                }
            }
        }
        let fits = counted.iter().filter(|one| one.instructions() <= target.allowed);
        if let Some(best) = fits.min_by(|a, b| a.found.error.total_cmp(&b.found.error)) {
            found = best.found.clone();
        }
    }
    let title = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let mut text = describe(&title, &found, &target, options);
    for one in &counted {
        text.push_str(&describe_count(one, &target));
    }
    if let Some(reason) = &without_count {
        let _ = writeln!(text, "  not counted: {reason}");
    }
    text.push_str(&tried_and_calls(&study, &title, &found));
    if arguments.measure {
        text.push_str(&measured(&study, &found, &budget).with_context(in_scene)?);
    }
    output::write(arguments.output.as_deref(), &text)
}

fn on_target(integrator: Integrator) -> Option<TargetIntegrator> {
    match integrator {
        Integrator::Rk4 => Some(TargetIntegrator::RungeKutta),
        Integrator::LinearlyImplicit => Some(TargetIntegrator::LinearlyImplicit),
        _ => None,
    }
}

/// Builds and runs the program of a configuration.
fn count(study: &Study, one: &Affordable, core: Core, workshop: &Workshop) -> Result<StepOnTarget> {
    let configuration = &one.configuration;
    let integrator = on_target(configuration.integrator).context("an integrator of fixed cost")?;
    let program = MechanismProgram {
        title: configuration.key(),
        file: &study.file_with(configuration.modes, &configuration.fidelity),
        folder: study.folder(),
        scalar: configuration.scalar,
        integrator,
        step: Some(configuration.step),
        layout_tolerance: DEFAULT_LAYOUT_TOLERANCE,
    };
    step_on_target(&program, core, workshop)
}

fn describe(title: &str, found: &PlanWithin, target: &Target, options: &OnTarget) -> String {
    let one = &found.best;
    let configuration = &one.configuration;
    let (name, _) = target.core.clock();
    let (per_operation, is_counted) = target.per_operation(configuration.scalar);
    let predicted = per_operation * one.operations;
    let steps = match one.divisions {
        1 => "a step in a tick".to_owned(),
        number => format!("{number} steps in a tick"),
    };
    format!(
        "plan for `{title}` with ticks of {:e} s on a {name} at {:e} Hz: {:.4e} instructions, at {} cycles each on average and \
         {:.0} % of the tick\n\n{} modes, {}, {}, {}, {steps}\nerror {:.2e} in a run of the scene\npredicted cost: {:.3e} \
         instructions in a tick, {:.0} % of what there is time for: {:.3e} operations of compiled code, estimated, with \
         {per_operation:.1} instructions each, {}\n\n{}\ninstructions in a tick\n",
        options.tick,
        target.clock,
        target.allowed,
        options.cycles_per_instruction,
        100.0 * options.share,
        configuration.modes,
        configuration.fidelity,
        configuration.scalar.name(),
        configuration.integrator.name(),
        found.error,
        predicted,
        100.0 * predicted / target.allowed,
        one.operations,
        if is_counted { "as counted below" } else { "as is usual on this core (`--measure` counts)" },
        describe_reference(&found.reference)
    )
}

fn describe_count(one: &Counted, target: &Target) -> String {
    let (instructions, step) = (one.instructions(), &one.step);
    let configuration = &one.found.best.configuration;
    let stack_bound =
        step.stack_bound.map_or("without a bound".to_owned(), |bound| format!("at most {bound}"));
    format!(
        "  {} modes, {}, {}, {}, {} in a tick: predicted {:.4e}, counted {instructions:.4e} ({:.2} of it), {:.0} % of what there \
         is time for\n    {} bytes of code, {} of tables, {} of model and state, {} of stack, {stack_bound}\n",
        configuration.modes,
        configuration.fidelity,
        configuration.scalar.name(),
        configuration.integrator.name(),
        one.found.best.divisions,
        one.predicted,
        instructions / one.predicted,
        100.0 * instructions / target.allowed,
        step.code,
        step.tables,
        step.state,
        step.stack,
    )
}
