//! What a step costs, as far as it can be counted without running it.

use std::path::Path;

use ffrf_codegen::{Fidelity, GenerateOptions, Kernels, OperationCounts};
use ffrf_model::ReducedBody;

use super::TradeoffError;
use crate::scene::file::{FidelityValue, SceneFile};
use crate::scene::{Integrator, Scene, SceneError};

/// The cost of one evaluation of a mechanism's accelerations in compiled code.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StaticCost {
    /// Floating-point operations: those of the generated `prepare` of each body, counted, and those of joints and solve,
    /// estimated from the sizes of the blocks that are eliminated.
    pub operations: f64,
    /// Numbers of the models that generated code holds and that are not zero, counted.
    pub constants: usize,
    /// Numbers that the solve keeps on the stack, counted, and states and increments of a step, estimated.
    pub stack_numbers: usize,
}

/// States and increments that a step of any integrator holds at a time, about.
const STATES_HELD: usize = 8;

impl StaticCost {
    /// Counts a scene. Errors: the generator refuses a model.
    pub(super) fn of(file: &SceneFile, folder: &Path, scene: &Scene) -> Result<Self, TradeoffError> {
        let mechanism = &scene.mechanism;
        let (solve, numbers) = mechanism.solve_cost();
        let mut cost = Self { operations: 2.0 * solve, constants: 0, stack_numbers: numbers };
        let rows = mechanism.attached_row_counts();
        for (((name, table), body), rows) in file.bodies.iter().zip(mechanism.bodies()).zip(rows) {
            let modes = body.mode_count();
            cost.constants += body.nonzero_constants();
            cost.stack_numbers += STATES_HELD * (13 + 2 * modes);
            cost.operations += match &table.model {
                Some(path) if modes > 0 => {
                    let model = read(name, &folder.join(path))?;
                    let model = match &table.modes {
                        Some(modes) => {
                            model.with_selected_modes(&modes.0).map_err(ffrf_codegen::CodegenError::from)?
                        }
                        None => model,
                    };
                    prepare_operations(&model, &fidelity(table.fidelity.as_ref()))? as f64
                }
                _ => RIGID_OPERATIONS,
            };
            // Θ_ff behind the frame and behind each row: a rank-one update of the six by six block for each mode, and the
            // product of each row with the modes, with the frame, and with the other rows
            let (m, r) = (modes as f64, rows as f64);
            cost.operations += m * (2.0 * 21.0 + 12.0) + r * (2.0 * m * 8.0 + 2.0 * 36.0) + r * r * m;
        }
        Ok(cost)
    }
}

/// Velocity terms of a rigid body: two cross products, a product with the inertia, and sums.
const RIGID_OPERATIONS: f64 = 90.0;

/// Evaluations of the accelerations, with a factorisation each, that one step takes.
pub(super) fn evaluations_per_step(integrator: Integrator, iterations: f64) -> f64 {
    match integrator {
        Integrator::SymplecticEuler | Integrator::LinearlyImplicitEuler => 1.0,
        Integrator::Rk4 => 4.0,
        Integrator::Dopri5 => 7.0,
        Integrator::LinearlyImplicit | Integrator::Exponential => 2.0,
        Integrator::GeneralizedAlpha | Integrator::EnergyMomentum => iterations.max(1.0),
        Integrator::Radau5 => 3.0 * iterations.max(1.0),
        Integrator::Radau7 => 4.0 * iterations.max(1.0),
    }
}

fn read(name: &str, path: &Path) -> Result<ReducedBody, SceneError> {
    ReducedBody::read(path).map_err(|source| SceneError::Model {
        key: format!("bodies.{name}.model"),
        path: path.to_owned(),
        source: Box::new(source),
    })
}

/// As scenes read it; what is wrong was refused when the scene was composed.
fn fidelity(value: Option<&FidelityValue>) -> Fidelity {
    match value {
        Some(FidelityValue::Level(name)) => Fidelity::from_name(name).unwrap_or_default(),
        Some(FidelityValue::Terms(names)) => {
            Fidelity::from_term_names(names.iter().map(String::as_str)).unwrap_or_default()
        }
        None => Fidelity::Full,
    }
}

/// Operations of the generated function that a mechanism asks a body for at every state.
fn prepare_operations(model: &ReducedBody, fidelity: &Fidelity) -> Result<usize, ffrf_codegen::CodegenError> {
    let options = GenerateOptions { fidelity: fidelity.clone(), ..GenerateOptions::default() };
    let kernels = Kernels::formulate_one(model, &options, "prepare")?;
    Ok(kernels.kernels().iter().map(|kernel| OperationCounts::of(kernel).total()).sum())
}
