//! The account of the modes found: residuals, orthogonality, effective masses, counts.

use std::f64::consts::TAU;

use faer::Mat;
use ffrf_model::{Mode, ModeKind};

use super::block::{column_norm, tall_gram};
use super::inertia_count::CountingShift;
use super::participation::{Participation, modal_masses};
use super::problem::Problem;
use super::rigid::RigidModes;
use super::{ModeBasis, ModeEntry, ModeReport, ModeSolution, RigidModeEntry};

/// Eigenvalues below this part of the elastic scale are zero: it is the round-off of a solve, not a spring.
const ZERO: f64 = 1e-8;
/// Modes that are worked on at once, so that few products stand in memory beside the shapes.
pub(crate) const GROUP: usize = 16;

/// Modes that a search has found, polished and counted.
pub(crate) struct Found {
    /// λ = ω², ascending. Units: (rad/s)².
    pub values: Vec<f64>,
    /// Mass-orthonormal shapes on the free degrees of freedom, in canonical form.
    pub shapes: Mat<f64>,
    /// Where the eigenvalues were counted.
    pub limit: CountingShift,
    /// Eigenvalues below the limit by Sturm count.
    pub counted: usize,
    /// How they were found, in words.
    pub method: String,
    /// Values in the sparse factor; 0 for the dense method.
    pub factor_values: usize,
    /// True if the first mode that is not kept has the frequency of the last that is.
    pub cut_repeated: bool,
}

/// Fills the report and keeps the first `count` modes.
pub(crate) fn account(
    problem: &Problem<'_>,
    rigid: &RigidModes,
    elastic_scale: f64,
    count: usize,
    found: Found,
) -> ModeSolution {
    let kind = if problem.held.is_empty() { ModeKind::FreeFree } else { ModeKind::Clamped };
    let Found { values, mut shapes, .. } = found;
    shapes.truncate(shapes.nrows(), count);
    let zero = ZERO * elastic_scale;
    let participation = Participation::on_free(problem);
    let mut orthogonality_error = 0.0_f64;
    let mut entries: Vec<ModeEntry> = Vec::with_capacity(count);
    for first in (0..count).step_by(GROUP) {
        let end = (first + GROUP).min(count);
        let group = shapes.get(.., first..end);
        let forces = problem.stiffness_times(group);
        let mass_group = problem.mass_times(group);
        let products = tall_gram(shapes.get(.., 0..end), mass_group.as_ref(), problem.threads);
        orthogonality_error = orthogonality_error.max(deviation_from_identity(&products, first));
        let masses = modal_masses(group, mass_group.as_ref());
        let effective = participation.of(group, &masses);
        for (k, effective) in effective.into_iter().enumerate() {
            let value = values[first + k];
            let difference =
                Mat::from_fn(group.nrows(), 1, |i, _| forces[(i, k)] - value * mass_group[(i, k)]);
            let norm = column_norm(forces.as_ref(), k);
            let residual = column_norm(difference.as_ref(), 0);
            entries.push(ModeEntry {
                number: first + k + 1,
                kind,
                frequency_hz: Some(if value.abs() < zero { 0.0 } else { hertz(value) }),
                residual: Some(if norm > 0.0 { residual / norm } else { 0.0 }),
                effective_mass: effective.mass,
                effective_inertia: effective.inertia,
            });
        }
    }
    let modes = entries.iter().map(|entry| Mode { kind, frequency_hz: entry.frequency_hz }).collect();
    let rigid_modes = rigid
        .rayleigh
        .iter()
        .zip(&rigid.residuals)
        .map(|(&value, &residual)| RigidModeEntry { frequency_hz: hertz(value.abs()), residual })
        .collect();
    let report = ModeReport {
        method: found.method,
        rigid_modes,
        mechanisms: values[..count].iter().filter(|value| value.abs() < zero).count(),
        orthogonality_error,
        counted: Some(found.counted),
        found: found.limit.below + rigid.count(),
        counted_below_hz: Some(hertz(found.limit.shift)),
        cut_repeated: found.cut_repeated,
        total_mass: participation.total_mass,
        total_inertia: participation.total_inertia,
        loose_dofs: problem.loose.len(),
        factor_values: found.factor_values,
        modes: entries,
    };
    ModeSolution { basis: ModeBasis { shapes: problem.expand_all(shapes), modes }, report }
}

/// Largest deviation from the identity of the columns of ΦᵀMΦ from `first` on, as far as the diagonal.
fn deviation_from_identity(products: &Mat<f64>, first: usize) -> f64 {
    let mut error = 0.0_f64;
    for j in 0..products.ncols() {
        for i in 0..=first + j {
            let expected = if i == first + j { 1.0 } else { 0.0 };
            error = error.max((products[(i, j)] - expected).abs());
        }
    }
    error
}

/// Frequency of an eigenvalue ω²; negative eigenvalues, which only round-off makes, count as zero.
pub(crate) fn hertz(value: f64) -> f64 {
    value.max(0.0).sqrt() / TAU
}
