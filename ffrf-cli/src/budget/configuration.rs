//! What a configuration of a scene takes of a core: the program of its mechanism, as `ffrf plan` and `ffrf tradeoff` count it.

use anyhow::{Context, Result};
use ffrf_codegen::DEFAULT_LAYOUT_TOLERANCE;
use ffrf_host::scene::Integrator;
use ffrf_host::tradeoff::{Configuration, Study};

use super::program::MechanismProgram;
use super::{StepOnTarget, Workshop, step_on_target};
use crate::arguments::{Core, TargetIntegrator};

/// The integrator as programs for a target have it; none whose work varies from step to step.
pub(crate) fn of_fixed_cost(integrator: Integrator) -> Option<TargetIntegrator> {
    match integrator {
        Integrator::Rk4 => Some(TargetIntegrator::RungeKutta),
        Integrator::LinearlyImplicit => Some(TargetIntegrator::LinearlyImplicit),
        _ => None,
    }
}

/// Builds and runs the program of a configuration. Errors: see [`step_on_target`]; the work of the integrator varies.
pub(crate) fn configuration_on_target(
    study: &Study,
    one: &Configuration,
    core: Core,
    workshop: &Workshop,
) -> Result<StepOnTarget> {
    let integrator = of_fixed_cost(one.integrator).context("expected an integrator of fixed cost")?;
    let program = MechanismProgram {
        title: one.key(),
        file: &study.file_with(&one.modes, &one.fidelity),
        folder: study.folder(),
        scalar: one.scalar,
        integrator,
        step: Some(one.step),
        layout_tolerance: DEFAULT_LAYOUT_TOLERANCE,
        straight_line: false,
    };
    step_on_target(&program, core, workshop)
}
