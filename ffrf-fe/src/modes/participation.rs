//! Effective masses: how much of the part's inertia a mode takes along when its support moves.

use faer::{Mat, MatRef, Par};

use crate::FeModel;

use super::block::gram;
use super::problem::{Problem, mass_times_full};
use super::rigid::rigid_fields;

/// Effective masses of shapes, and the totals that their sums approach from below.
pub(crate) struct Participation {
    /// M times the translations along the frame axes and the rotations about them. Shape: rows of Φ x 6.
    mass_fields: Mat<f64>,
    /// Mass of the part. Units: kg.
    pub total_mass: f64,
    /// Moments of inertia about the frame axes. Units: kg m².
    pub total_inertia: [f64; 3],
}

/// What one mode takes along.
pub(crate) struct EffectiveMass {
    /// (φᵀ M e_i)² / φᵀMφ. Units: kg.
    pub mass: [f64; 3],
    /// (φᵀ M (e_i × x))² / φᵀMφ, about the frame origin. Units: kg m².
    pub inertia: [f64; 3],
}

impl Participation {
    /// Of shapes on all degrees of freedom of a model.
    pub fn new(model: &FeModel) -> Self {
        let fields = rigid_fields(&model.nodes.positions, [0.0; 3], 1.0);
        let mass_fields = mass_times_full(&model.mass, &fields);
        let totals = modal_masses(fields.as_ref(), mass_fields.as_ref());
        Self { mass_fields, total_mass: totals[0], total_inertia: [totals[3], totals[4], totals[5]] }
    }

    /// Of shapes on the free degrees of freedom.
    pub fn on_free(problem: &Problem<'_>) -> Self {
        let all = Self::new(problem.model);
        Self { mass_fields: problem.restrict(all.mass_fields.as_ref()), ..all }
    }

    /// Participation of shapes Φ with φᵀMφ at hand.
    pub fn of(&self, shapes: MatRef<'_, f64>, modal_masses: &[f64]) -> Vec<EffectiveMass> {
        let factors = gram(self.mass_fields.as_ref(), shapes, Par::Seq);
        let effective = |mode: usize, first: usize| {
            [0, 1, 2].map(|i| {
                let factor = factors[(first + i, mode)];
                if modal_masses[mode] > 0.0 { factor * factor / modal_masses[mode] } else { 0.0 }
            })
        };
        (0..modal_masses.len())
            .map(|mode| EffectiveMass { mass: effective(mode, 0), inertia: effective(mode, 3) })
            .collect()
    }
}

/// φᵀMφ of each column.
pub(crate) fn modal_masses(shapes: MatRef<'_, f64>, mass_shapes: MatRef<'_, f64>) -> Vec<f64> {
    (0..shapes.ncols())
        .map(|j| (0..shapes.nrows()).map(|i| shapes[(i, j)] * mass_shapes[(i, j)]).sum())
        .collect()
}
