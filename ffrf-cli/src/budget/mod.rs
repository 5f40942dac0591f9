//! `ffrf budget`: what a body or a mechanism takes of a microcontroller, measured in an emulator.
//!
//! A small program is written, built and run for each core and scalar. It links only if no panic is reachable and nothing
//! allocates. Needs cargo with the target thumbv7em-none-eabihf and qemu-system-arm; `firmware/run.sh` sets both up.

mod configuration;
mod elf;
mod emulator;
mod mechanism_code;
mod program;
mod report;
mod stack_bound;

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use ffrf_codegen::ScalarType;
use serde::{Deserialize, Serialize};

use crate::arguments::{Budget, Core, TargetScalar};
use crate::output;
pub(crate) use configuration::{configuration_on_target, of_fixed_cost};
use elf::Program;
use emulator::{Run, build, emulate};
use program::{MechanismProgram, Subject};

/// The function of the program that takes a step.
const STEP: &str = "measured_step";

/// What was found for one core and scalar.
pub(crate) struct Found {
    baseline: Program,
    step: Program,
    run: Run,
    kernels: Option<(Program, Run)>,
    /// The most stack that a step can take, or why that is not known. Units: bytes.
    bound: Result<u64>,
}

/// Runs the command.
pub fn run(arguments: &Budget) -> Result<()> {
    let cores =
        if arguments.target.is_empty() { &[Core::CortexM4F, Core::CortexM7][..] } else { &arguments.target };
    let scalars = if arguments.scalar.is_empty() {
        &[TargetScalar::F32, TargetScalar::F64][..]
    } else {
        &arguments.scalar
    };
    let workshop = Workshop { sources: arguments.sources.clone(), folder: arguments.folder.clone() };
    let mut text = String::new();
    for scalar in scalars {
        let subject = subject(arguments, *scalar)?;
        for core in cores {
            let found = measure(&subject, *core, &workshop, &arguments.opt_level)?;
            text.push_str(&report::text(&subject, *core, *scalar, &found));
            let painted = found.run.most_stack();
            if let Ok(bound) = found.bound
                && painted > bound
            {
                bail!("{painted} bytes of stack were touched, more than the bound of {bound}");
            }
        }
    }
    text.push_str(report::ASSUMPTIONS);
    output::write(None, &text)
}

fn subject(arguments: &Budget, scalar: TargetScalar) -> Result<Subject> {
    let scalar = match scalar {
        TargetScalar::F32 => ScalarType::F32,
        TargetScalar::F64 => ScalarType::F64,
    };
    if arguments.file.extension().is_some_and(|extension| extension == "toml") {
        if arguments.modes.is_some() {
            bail!("--modes: a scene says itself how many modes its bodies have");
        }
        return program::scene(arguments, scalar);
    }
    program::body(arguments, scalar)
}

/// Where programs are written and built.
pub(crate) struct Workshop {
    /// The ffrf sources.
    pub(crate) sources: PathBuf,
    /// The folder of the programs; in the sources, if nothing is said.
    pub(crate) folder: Option<PathBuf>,
}

impl Workshop {
    fn folder(&self) -> PathBuf {
        self.folder.clone().unwrap_or_else(|| self.sources.join("firmware/target/budget"))
    }
}

/// What a step of a mechanism takes of a core.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct StepOnTarget {
    /// The most instructions of 32 steps.
    pub instructions: u64,
    /// Machine code, more than the same program without the step has. Units: bytes.
    pub code: u64,
    /// Constants in tables, likewise. Units: bytes.
    pub tables: u64,
    /// Model and state, where they are kept. Units: bytes.
    pub state: u64,
    /// Stack that a step touches. Units: bytes.
    pub stack: u64,
    /// The most that the machine code can take; none where that is not known. Units: bytes.
    pub stack_bound: Option<u64>,
}

impl StepOnTarget {
    /// What is kept between steps: constants in tables, model and state. Units: bytes.
    pub fn data(&self) -> u64 {
        self.tables + self.state
    }
}

/// Writes, builds and runs the program of a mechanism. Errors: the scene has no counterpart in the macro, the tools for the
/// target are not there, or more stack was touched than the bound.
fn step_on_target(program: &MechanismProgram<'_>, core: Core, workshop: &Workshop) -> Result<StepOnTarget> {
    let subject = program::mechanism(program)?;
    let found = measure(&subject, core, workshop, USUAL_LEVEL)?;
    let stack = found.run.most_stack();
    let stack_bound = found.bound.ok();
    if let Some(bound) = stack_bound.filter(|bound| stack > *bound) {
        bail!("{stack} bytes of stack were touched, more than the bound of {bound}");
    }
    let (step, base) = (found.step.sizes, found.baseline.sizes);
    Ok(StepOnTarget {
        instructions: found.run.measured.iter().map(|one| one.most).max().unwrap_or(0),
        code: step.code.saturating_sub(base.code),
        tables: step.tables.saturating_sub(base.tables),
        state: found.run.state,
        stack,
        stack_bound,
    })
}

/// How rustc optimises where nothing is said: for speed.
const USUAL_LEVEL: &str = "3";

fn measure(subject: &Subject, core: Core, workshop: &Workshop, opt_level: &str) -> Result<Found> {
    let folder = workshop.folder();
    program::write(subject, &folder, &workshop.sources, opt_level)?;
    let linked = |name: &str| -> Result<_> {
        let path = build(&folder, core, name)?;
        let bytes = std::fs::read(&path).with_context(|| format!("{}", path.display()))?;
        Ok((path, Program::parse(&bytes)?))
    };
    let (_, baseline) = linked("baseline")?;
    let (path, step) = linked("step")?;
    let run = emulate(&path, core)?;
    let kernels = match &subject.kernels {
        None => None,
        Some(_) => {
            let (path, program) = linked("kernels")?;
            Some((program, emulate(&path, core)?))
        }
    };
    let function = step.function_named(STEP).with_context(|| format!("no function {STEP} in the program"))?;
    let bound = stack_bound::bound(&step, function);
    Ok(Found { baseline, run, kernels, bound, step })
}
