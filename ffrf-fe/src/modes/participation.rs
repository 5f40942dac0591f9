//! Effective masses: how much of the part's inertia a mode takes along when its support moves.

use faer::{Mat, MatRef, Par};

use crate::{FeModel, SparseMatrix};

use super::block::gram;
use super::problem::mass_times_full;
use super::rigid::rigid_fields;

/// Effective masses of some shapes, and the totals that their sums approach from below.
pub(crate) struct Participation {
    /// Per mode: (φᵀ M e_i)² / φᵀMφ. Units: kg.
    pub mass: Vec<[f64; 3]>,
    /// Per mode: (φᵀ M (e_i × x))² / φᵀMφ, about the frame origin. Units: kg m².
    pub inertia: Vec<[f64; 3]>,
    /// Mass of the part. Units: kg.
    pub total_mass: f64,
    /// Moments of inertia about the frame axes. Units: kg m².
    pub total_inertia: [f64; 3],
}

/// Participation of `shapes` (3N x M) with M Φ at hand.
pub(crate) fn participation(
    model: &FeModel,
    shapes: MatRef<'_, f64>,
    mass_shapes: MatRef<'_, f64>,
) -> Participation {
    let fields = rigid_fields(&model.nodes.positions, [0.0; 3], 1.0);
    let factors = gram(fields.as_ref(), mass_shapes, Par::Seq);
    let modal_masses = modal_masses(shapes, mass_shapes);
    let effective = |mode: usize, first: usize| {
        [0, 1, 2].map(|i| {
            let factor = factors[(first + i, mode)];
            if modal_masses[mode] > 0.0 { factor * factor / modal_masses[mode] } else { 0.0 }
        })
    };
    let totals = diagonal(&fields, &model.mass);
    Participation {
        mass: (0..shapes.ncols()).map(|mode| effective(mode, 0)).collect(),
        inertia: (0..shapes.ncols()).map(|mode| effective(mode, 3)).collect(),
        total_mass: totals[0],
        total_inertia: [totals[3], totals[4], totals[5]],
    }
}

/// φᵀMφ of each column.
pub(crate) fn modal_masses(shapes: MatRef<'_, f64>, mass_shapes: MatRef<'_, f64>) -> Vec<f64> {
    (0..shapes.ncols())
        .map(|j| (0..shapes.nrows()).map(|i| shapes[(i, j)] * mass_shapes[(i, j)]).sum())
        .collect()
}

fn diagonal(fields: &Mat<f64>, mass: &SparseMatrix) -> Vec<f64> {
    modal_masses(fields.as_ref(), mass_times_full(mass, fields).as_ref())
}
