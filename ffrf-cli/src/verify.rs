//! `ffrf verify`: the generated kernels against the finite-element model, node by node.
//!
//! Deviations are measured on the scale that the Cauchy-Schwarz inequality gives each block, see
//! [`ffrf_fe::oracle::Scales`]: a block that vanishes up to round-off (B of free-free modes) then shows that
//! round-off and not a ratio of two of them.

use std::fmt::Write as _;

use anyhow::{Context, Result, bail};
use ffrf_codegen::GenerateOptions;
use ffrf_fe::geometric_stiffness::{SecondOrder, second_order_displacements};
use ffrf_fe::oracle::{Elastic, Oracle, OracleState, OracleValues, group_of};
use ffrf_fe::{FeModel, ModeBasis};
use ffrf_host::kernels::GeneratedKernels;
use ffrf_model::ReducedBody;

use crate::arguments::Verify;
use crate::sample_states::{ANGULAR_VELOCITY, DISPLACEMENT, sample_forces, sample_states};
use crate::{fe_input, modes, output, stiffening};

/// Multiples of the unit round-off of the elastic energy's terms that a projected stiffness may carry:
/// each entry of ΨᵀKΨ is a sum of some hundred to some thousand products, whose errors mostly cancel.
const STIFFNESS_ROUND_OFF: f64 = 16.0 * f64::EPSILON;

/// Runs the command.
pub fn run(arguments: &Verify) -> Result<()> {
    let body = ReducedBody::read(&arguments.model)?;
    let kernels = GeneratedKernels::new(&body, &GenerateOptions::default())
        .with_context(|| format!("{}", arguments.model.display()))?;
    let model = fe_input::read(&arguments.files, &mut output::complain)?;
    let solution = modes::with_progress(|progress| {
        modes::solve(
            &model,
            &arguments.choice,
            Some(body.mode_count()),
            arguments.files.conversion(),
            progress,
        )
    })?;
    let fields = match &body.geometric_stiffness {
        Some(_) => Some(second_order(&model, &solution.basis, arguments)?),
        None => None,
    };
    let mut oracle = Oracle::new(&model, &solution.basis)?;
    if oracle.mode_count() != body.mode_count() {
        bail!(
            "{} has {} modes, the mode basis has {}",
            arguments.model.display(),
            body.mode_count(),
            oracle.mode_count()
        );
    }
    if let Some(fields) = &fields {
        oracle = oracle.with_second_order(fields)?;
    }
    if arguments.states == 0 {
        bail!("--states: at least one state is needed");
    }
    let mut table = Table::default();
    for (index, state) in sample_states(&oracle, arguments.states, arguments.seed).iter().enumerate() {
        let values = oracle.evaluate(state);
        compare(&mut table, &body, &kernels, state, &values, arguments.seed.wrapping_add(index as u64));
    }
    output::say(&format!(
        "{} random states (seed {}): displacements up to {DISPLACEMENT} of the body's size {:.4}, angular \
         velocity components up to {ANGULAR_VELOCITY} rad/s\n",
        arguments.states,
        arguments.seed,
        oracle.size()
    ))?;
    output::say(&format!("kernels: {}\n{}", kernels.description(), table.text(arguments.tolerance)))?;
    if model.stiffness.is_none() {
        output::say("the elastic energy and forces were not checked: no stiffness matrix given\n")?;
    }
    let failed = table.failed(arguments.tolerance);
    if failed.is_empty() {
        output::say(&format!("verified: every deviation is within {:.0e}\n", arguments.tolerance))
    } else {
        bail!("deviation above {:.0e}: {}", arguments.tolerance, failed.join(", "))
    }
}

/// The displacements that make up for geometric stiffness, from the elements.
fn second_order(model: &FeModel, basis: &ModeBasis, arguments: &Verify) -> Result<SecondOrder> {
    if arguments.choice.mode_shapes.is_some() {
        bail!(
            "geometric stiffness can be verified for computed modes: give --modes, and --clamp as for `ffrf reduce`"
        );
    }
    let support = stiffening::support(model, &arguments.choice)?;
    let conversion = arguments.files.conversion();
    let elasticity = stiffening::elasticity(arguments.elastic, conversion);
    second_order_displacements(model, basis, &support, elasticity).context("geometric stiffness")
}

/// Largest deviation of each quantity, in the order of first mention.
#[derive(Default)]
struct Table {
    rows: Vec<Row>,
}

struct Row {
    quantity: String,
    deviation: f64,
    /// What round-off in the input of the comparison alone may amount to, relative; 0 for most.
    allowance: f64,
}

impl Table {
    fn note(&mut self, quantity: &str, deviation: f64, scale: f64, allowance: f64) {
        let deviation = if deviation == 0.0 { 0.0 } else { deviation / scale };
        let row = match self.rows.iter().position(|row| row.quantity == quantity) {
            Some(index) => &mut self.rows[index],
            None => {
                self.rows.push(Row { quantity: quantity.to_owned(), deviation: 0.0, allowance: 0.0 });
                let last = self.rows.len() - 1;
                &mut self.rows[last]
            }
        };
        // A deviation that is not a number must not pass as a small one.
        if deviation.is_nan() || deviation > row.deviation {
            row.deviation = if deviation.is_nan() { f64::INFINITY } else { deviation };
        }
        row.allowance = row.allowance.max(allowance);
    }

    fn text(&self, tolerance: f64) -> String {
        let mut text = format!("{:<44} {:>10}  {:>9}\n", "largest relative deviation", "", "limit");
        for row in &self.rows {
            let limit = tolerance.max(row.allowance);
            let verdict = if row.deviation <= limit { "" } else { "  FAILED" };
            let _ = writeln!(text, "  {:<42} {:>10.2e}  {limit:>9.1e}{verdict}", row.quantity, row.deviation);
        }
        text
    }

    fn failed(&self, tolerance: f64) -> Vec<String> {
        self.rows
            .iter()
            .filter(|row| row.deviation > tolerance.max(row.allowance))
            .map(|row| format!("{} ({:.2e})", row.quantity, row.deviation))
            .collect()
    }
}

const GROUPS: [&str; 3] = ["t", "r", "f"];

fn compare(
    table: &mut Table,
    body: &ReducedBody,
    kernels: &GeneratedKernels,
    state: &OracleState,
    values: &OracleValues,
    seed: u64,
) {
    let OracleState { q, velocity, omega, q_dot } = state;
    let scales = &values.scales;
    let mass = kernels.mass_matrix(q);
    for (i, row) in values.mass_matrix.iter().enumerate() {
        for (j, expected) in row.iter().enumerate() {
            let (a, b) = (group_of(i).min(group_of(j)), group_of(i).max(group_of(j)));
            let quantity = format!("mass matrix, block {}{}", GROUPS[a], GROUPS[b]);
            table.note(&quantity, (mass[i][j] - expected).abs(), scales.column[a] * scales.column[b], 0.0);
        }
    }
    let gyroscopic = kernels.quadratic_velocity(q, omega, q_dot);
    for (i, expected) in values.quadratic_velocity.iter().enumerate() {
        let quantity = format!("gyroscopic forces, block {}", GROUPS[group_of(i)]);
        let scale = scales.column[group_of(i)] * scales.convective;
        table.note(&quantity, (gyroscopic[i] - expected).abs(), scale, 0.0);
    }
    let kinetic = kernels.kinetic_energy(q, velocity, omega, q_dot);
    table.note("kinetic energy", (kinetic - values.kinetic_energy).abs(), values.kinetic_energy, 0.0);
    let momenta = [
        ("linear momentum", kernels.linear_momentum(q, velocity, omega, q_dot), values.linear_momentum, 0),
        ("angular momentum", kernels.angular_momentum(q, velocity, omega, q_dot), values.angular_momentum, 1),
    ];
    for (quantity, found, expected, group) in momenta {
        for (found, expected) in found.iter().zip(expected) {
            table.note(quantity, (found - expected).abs(), scales.column[group] * scales.velocity, 0.0);
        }
    }
    if let Some(elastic) = &values.elastic {
        let found = kernels.elastic_energy(q);
        let allowance =
            STIFFNESS_ROUND_OFF * elastic.absolute_energy / elastic.energy.abs().max(f64::MIN_POSITIVE);
        table.note("elastic energy", (found - elastic.energy).abs(), elastic.energy.abs(), allowance);
        equations(table, body, kernels, state, values, elastic, seed);
    }
}

/// The accelerations of the kernel put into the equations of motion of the nodes, under random forces.
fn equations(
    table: &mut Table,
    body: &ReducedBody,
    kernels: &GeneratedKernels,
    state: &OracleState,
    values: &OracleValues,
    elastic: &Elastic,
    seed: u64,
) {
    let OracleState { q, omega, q_dot, .. } = state;
    let scales = &values.scales;
    let size = values.quadratic_velocity.len();
    let force = sample_forces(size, |i| scales.column[group_of(i)] * scales.convective, seed);
    let acceleration = kernels.forward_dynamics(q, omega, q_dot, &force);
    let square = |row: &Vec<f64>| row.iter().zip(&acceleration).map(|(m, w)| m * w).sum::<f64>();
    let inertial: Vec<f64> = values.mass_matrix.iter().map(square).collect();
    let norm = inertial.iter().zip(&acceleration).map(|(f, w)| f * w).sum::<f64>().max(0.0).sqrt();
    for i in 0..size {
        let mut residual = inertial[i] + values.quadratic_velocity[i] - force[i];
        let mut scale = scales.column[group_of(i)] * (norm + scales.convective);
        if let Some(mu) = i.checked_sub(6) {
            let damping: f64 = body.damping[mu].iter().zip(q_dot).map(|(d, rate)| d * rate).sum();
            residual += elastic.force[mu] + damping;
            scale += elastic.force.iter().fold(0.0, |max: f64, entry| max.max(entry.abs())) + damping.abs();
        }
        let quantity = format!("equations of motion, block {}", GROUPS[group_of(i)]);
        table.note(&quantity, residual.abs(), scale, 0.0);
    }
}
