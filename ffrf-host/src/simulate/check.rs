//! What a scene is before it moves: degrees of freedom, redundant rows, residuals.

use ffrf_runtime::mechanism::{Assembly, Constrained};
use ffrf_runtime::{FlexibleBody, GeneralisedForce, ModalVector, PlacedMarker, State};
use nalgebra::{Cholesky, DMatrix, DVector};

use super::SimulationError;
use crate::HostModal;
use crate::scene::Scene;

/// What a scene is before it moves.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneCheck {
    /// Velocities of all bodies: 6 and the modes of each.
    pub velocities: usize,
    /// Constraint rows of all joints and drives.
    pub rows: usize,
    /// Names of rows that say nothing new here: joint and what it holds.
    pub redundant: Vec<String>,
    /// Bodies that no joint holds.
    pub flying: Vec<String>,
    /// What is left to move.
    pub degrees_of_freedom: usize,
    /// For each joint, the largest residual of the file's state: position (m or rad) and velocity.
    pub residuals: Vec<(String, [f64; 2])>,
    /// Largest residuals once assembled.
    pub assembled: [f64; 2],
    /// Largest residual of the accelerations there. Units: m/s² or rad/s².
    pub accelerations: f64,
}

/// A row counts as redundant if less than this of it is new, in the metric of kinetic energy.
const NEW: f64 = 1e-7;

/// Examines a scene. Errors: it cannot be assembled.
pub fn check(scene: &Scene) -> Result<SceneCheck, SimulationError> {
    let mechanism = &scene.mechanism;
    let joints = |state: &[State<HostModal>]| {
        Constrained(mechanism).evaluate(0.0, state.to_vec(), None, |_, storage| {
            storage
                .evaluated()
                .map(|joint| {
                    joint.residuals().fold([0.0_f64; 2], |largest, [position, velocity]| {
                        [largest[0].max(position.abs()), largest[1].max(velocity.abs())]
                    })
                })
                .collect::<Vec<_>>()
        })
    };
    let refused =
        |error: ffrf_runtime::StepError| SimulationError::Step { time: 0.0, reason: error.to_string() };
    let residuals = joints(&scene.initial).map_err(refused)?;
    let (state, _) = scene.assembled()?;
    let assembled = joints(&state).map_err(refused)?;
    let accelerations = crate::scene::residuals(mechanism, 0.0, &state).map_err(refused)?;
    let (gradients, names) = gradients(scene, &state).map_err(refused)?;
    let redundant = redundant(&gradients, &names);
    let velocities = mechanism.bodies().iter().map(|body| 6 + body.mode_count()).sum();
    let rows = names.len();
    let held = |body: usize| {
        mechanism
            .connections()
            .iter()
            .any(|joint| [joint.first.body, joint.second.body].contains(&Some(body)))
    };
    let names = scene.body_names.iter().enumerate();
    let flying = names.filter(|(body, _)| !held(*body)).map(|(_, name)| name.clone()).collect();
    Ok(SceneCheck {
        flying,
        velocities,
        rows,
        degrees_of_freedom: velocities + redundant.len() - rows,
        redundant,
        residuals: scene.connection_names.iter().cloned().zip(residuals).collect(),
        assembled: assembled.iter().fold([0.0; 2], |sum, one| [sum[0].max(one[0]), sum[1].max(one[1])]),
        accelerations: accelerations.iter().fold(0.0, |largest, joint| joint.left[2].max(largest)),
    })
}

/// Rows of the Jacobian times L⁻ᵀ of the mass matrix L Lᵀ, body by body, with their names.
fn gradients(
    scene: &Scene,
    state: &[State<HostModal>],
) -> Result<(Vec<DVector<f64>>, Vec<String>), ffrf_runtime::StepError> {
    let mechanism = &scene.mechanism;
    let mut starts = Vec::new();
    let mut total = 0;
    for body in mechanism.bodies() {
        starts.push(total);
        total += 6 + body.mode_count();
    }
    let factors: Vec<Option<Cholesky<f64, nalgebra::Dyn>>> = mechanism
        .bodies()
        .iter()
        .zip(state)
        .map(|(body, state)| Cholesky::new(mass_matrix(body, state)))
        .collect();
    Constrained(mechanism).evaluate(0.0, state.to_vec(), None, |_, storage| {
        let (mut gradients, mut names) = (Vec::new(), Vec::new());
        for (index, (connection, joint)) in
            mechanism.connections().iter().zip(storage.evaluated()).enumerate()
        {
            for (k, row) in joint.rows.iter().enumerate() {
                let mut gradient = DVector::zeros(total);
                let ends = [(&connection.first, &row.first), (&connection.second, &row.second)];
                for (attachment, wrench) in ends {
                    let Some(body) = attachment.body else { continue };
                    let marker = &mechanism.markers()[body][attachment.marker];
                    let force = PlacedMarker::new(marker, &state[body]).generalised_force(wrench);
                    let mut part = flat(&force);
                    if let Some(factor) = &factors[body] {
                        factor.l_dirty().solve_lower_triangular_mut(&mut part);
                    }
                    let mut place = gradient.rows_mut(starts[body], part.len());
                    place += part;
                }
                gradients.push(gradient);
                names.push(format!("{}: {}", scene.connection_names[index], connection.kind.row_name(k)));
            }
        }
        (gradients, names)
    })
}

fn mass_matrix(body: &crate::HostBody, state: &State<HostModal>) -> DMatrix<f64> {
    let prepared = body.prepare(&state.modal_coordinates, &state.angular_velocity, &state.modal_rates);
    let (modes, rigid) = (body.mode_count(), prepared.rigid_mass());
    let modal = body.modal_mass().dense();
    let coupling = prepared.coupling();
    DMatrix::from_fn(6 + modes, 6 + modes, |i, j| match (i < 6, j < 6) {
        (true, true) => rigid[(i, j)],
        (true, false) => coupling[i].as_slice()[j - 6],
        (false, true) => coupling[j].as_slice()[i - 6],
        (false, false) => modal[(i - 6, j - 6)],
    })
}

fn flat(force: &GeneralisedForce<HostModal>) -> DVector<f64> {
    let numbers = force.force.iter().chain(force.moment.iter()).chain(force.modal.as_slice());
    DVector::from_iterator(6 + force.modal.as_slice().len(), numbers.copied())
}

/// The rows that earlier rows imply, by modified Gram-Schmidt with a second pass.
fn redundant(gradients: &[DVector<f64>], names: &[String]) -> Vec<String> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut redundant = Vec::new();
    for (gradient, name) in gradients.iter().zip(names) {
        let size = gradient.norm();
        let mut new = gradient.clone();
        for _ in 0..2 {
            for direction in &basis {
                new -= direction * direction.dot(&new);
            }
        }
        let rest = new.norm();
        if rest > NEW * size {
            basis.push(new / rest);
        } else {
            redundant.push(name.clone());
        }
    }
    redundant
}
