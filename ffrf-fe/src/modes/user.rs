//! Mode shapes that the user supplies, kept exactly as given.

use faer::{Mat, Par};
use ffrf_model::{Mode, ModeKind};

use crate::{FeError, FeModel, SparseMatrix};

use super::ModeError;
use super::account::hertz;
use super::block::gram;
use super::participation::{Participation, modal_masses};
use super::problem::{entries, mass_times_full};
use super::{ModeBasis, ModeEntry, ModeReport, ModeSolution};

/// Takes shapes (3N x M) as the mode basis, without change.
///
/// The report has the frequency of each Rayleigh quotient and its residual if the model has a stiffness; the basis
/// has no frequencies, since the shapes need not be eigenmodes.
/// Errors: [`ModeError::ModeShapeRows`], [`ModeError::ModeShapeNotFinite`], [`ModeError::NoModesWanted`].
pub fn user_modes(model: &FeModel, shapes: Mat<f64>) -> Result<ModeSolution, FeError> {
    let rows = 3 * model.nodes.len();
    if shapes.nrows() != rows {
        return Err(ModeError::ModeShapeRows {
            nodes: model.nodes.len(),
            expected: rows,
            found: shapes.nrows(),
        }
        .into());
    }
    if shapes.ncols() == 0 {
        return Err(ModeError::NoModesWanted.into());
    }
    for column in 0..shapes.ncols() {
        if let Some(row) = shapes.col_as_slice(column).iter().position(|value| !value.is_finite()) {
            return Err(ModeError::ModeShapeNotFinite { row, column }.into());
        }
    }
    let mass_shapes = mass_times_full(&model.mass, &shapes);
    let masses = modal_masses(shapes.as_ref(), mass_shapes.as_ref());
    let participation = Participation::new(model);
    let effective = participation.of(shapes.as_ref(), &masses);
    let forces = model.stiffness.as_ref().map(|stiffness| times(stiffness, &shapes));
    let modes: Vec<ModeEntry> = (0..shapes.ncols())
        .map(|j| {
            let rayleigh =
                forces.as_ref().map(|forces| rayleigh(&shapes, &mass_shapes, forces, masses[j], j));
            ModeEntry {
                number: j + 1,
                kind: ModeKind::User,
                frequency_hz: rayleigh.map(|(value, _)| hertz(value)),
                residual: rayleigh.map(|(_, residual)| residual),
                effective_mass: effective[j].mass,
                effective_inertia: effective[j].inertia,
            }
        })
        .collect();
    let report = ModeReport {
        method: format!("{} mode shapes of the user, as given", shapes.ncols()),
        rigid_modes: Vec::new(),
        mechanisms: 0,
        orthogonality_error: scaled_orthogonality_error(&shapes, &mass_shapes, &masses),
        counted: None,
        found: shapes.ncols(),
        counted_below_hz: None,
        cut_repeated: false,
        total_mass: participation.total_mass,
        total_inertia: participation.total_inertia,
        loose_dofs: 0,
        factor_values: 0,
        modes,
    };
    let modes = vec![Mode { kind: ModeKind::User, frequency_hz: None }; shapes.ncols()];
    Ok(ModeSolution { basis: ModeBasis { shapes, modes }, report })
}

/// Rayleigh quotient λ and ||K φ - λ M φ|| / ||K φ||.
fn rayleigh(shapes: &Mat<f64>, mass_shapes: &Mat<f64>, forces: &Mat<f64>, mass: f64, j: usize) -> (f64, f64) {
    let energy: f64 = (0..shapes.nrows()).map(|i| shapes[(i, j)] * forces[(i, j)]).sum();
    let value = if mass > 0.0 { energy / mass } else { 0.0 };
    let (mut difference, mut norm) = (0.0, 0.0);
    for i in 0..shapes.nrows() {
        let force = forces[(i, j)];
        difference += (force - value * mass_shapes[(i, j)]).powi(2);
        norm += force.powi(2);
    }
    (value, if norm > 0.0 { (difference / norm).sqrt() } else { 0.0 })
}

/// K X for a matrix with both triangles stored.
pub(crate) fn times(matrix: &SparseMatrix, shapes: &Mat<f64>) -> Mat<f64> {
    let mut result = Mat::zeros(matrix.nrows(), shapes.ncols());
    for j in 0..shapes.ncols() {
        let column = result.col_as_slice_mut(j);
        for k in 0..matrix.ncols() {
            let factor = shapes[(k, j)];
            for (row, value) in entries(matrix, k) {
                column[row] += value * factor;
            }
        }
    }
    result
}

fn scaled_orthogonality_error(shapes: &Mat<f64>, mass_shapes: &Mat<f64>, masses: &[f64]) -> f64 {
    let products = gram(shapes.as_ref(), mass_shapes.as_ref(), Par::Seq);
    let mut error = 0.0_f64;
    for j in 0..masses.len() {
        for i in 0..j {
            let scale = (masses[i] * masses[j]).sqrt();
            if scale > 0.0 {
                error = error.max(products[(i, j)].abs() / scale);
            }
        }
    }
    error
}
