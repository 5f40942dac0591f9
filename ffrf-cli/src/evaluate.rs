//! `ffrf evaluate`: the kernels at given states.

use anyhow::{Context, Result};
use ffrf_codegen::GenerateOptions;
use ffrf_host::kernels::GeneratedKernels;
use ffrf_model::ReducedBody;

use crate::arguments::Evaluate;
use crate::states::{State, Values};
use crate::{output, states};

/// Runs the command.
pub fn run(arguments: &Evaluate) -> Result<()> {
    let body = ReducedBody::read(&arguments.model)?;
    let kernels = GeneratedKernels::new(&body, &GenerateOptions::default())
        .with_context(|| format!("{}", arguments.model.display()))?;
    let states = states::read(&arguments.states, body.mode_count())?;
    let values: Vec<Values> = states.iter().map(|state| evaluate(&kernels, state)).collect();
    let text = states::to_json(&values).with_context(|| format!("{}", arguments.states.display()))?;
    output::write(arguments.output.as_deref(), &text)
}

fn evaluate(kernels: &GeneratedKernels, state: &State) -> Values {
    let State { q, omega, q_dot, force, velocity } = state;
    Values {
        mass_matrix: kernels.mass_matrix(q),
        quadratic_velocity: kernels.quadratic_velocity(q, omega, q_dot),
        acceleration: kernels.forward_dynamics(q, omega, q_dot, force),
        kinetic_energy: kernels.kinetic_energy(q, velocity, omega, q_dot),
        elastic_energy: kernels.elastic_energy(q),
    }
}
