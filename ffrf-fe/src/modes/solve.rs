//! From a request to modes: choose a solver, check what it found, tell about it.

use std::f64::consts::TAU;

use faer::Mat;
use faer::sparse::SparseColMat;
use ffrf_model::{Mode, ModeKind};

use crate::{FeError, FeModel};

use super::ModeError;
use super::block::column_norm;
use super::canonical::{settle_repeated, settle_signs};
use super::dense::{self, Pairs, orthogonality_error};
use super::factor::Analysis;
use super::inertia_count::{CountingShift, counting_shift, eigenvalues_below};
use super::lanczos::{self, subspace_size};
use super::ordering::order;
use super::participation::participation;
use super::problem::Problem;
use super::rigid::RigidModes;
use super::scale::{elastic_scale, rayleigh_ritz};
use super::{
    Method, ModeBasis, ModeEntry, ModeReport, ModeRequest, ModeSolution, Progress, RigidModeEntry, Stage,
};

/// Largest problem that [`Method::Automatic`] solves densely: there both methods take about a second.
const DENSE_LIMIT: usize = 900;
/// Modes that the dense method returns beyond the wanted ones, to see the gap that follows.
const GUARD: usize = 4;
/// How often a search is widened before it is given up.
const ATTEMPTS: usize = 4;
/// Eigenvalues below this part of the elastic scale are zero: it is the round-off of a solve, not a spring.
const ZERO: f64 = 1e-8;

/// Computes the lowest elastic modes of K φ = λ M φ, mass-normalised, in ascending order of frequency.
///
/// Rigid-body modes that the supports leave are found from the node table, checked against K, projected out and
/// not counted. The result does not depend on the number of threads.
///
/// Errors: no stiffness, unknown or empty clamp, K not positive semidefinite, K resists rigid motion,
/// more modes wanted than there are, no convergence, or a mode missed ([`ModeError::ModesMissed`]).
/// Panics: never.
pub fn compute_modes(
    model: &FeModel,
    request: &ModeRequest,
    progress: &mut dyn FnMut(Progress),
) -> Result<ModeSolution, FeError> {
    Ok(solve(model, request, progress)?)
}

fn solve(
    model: &FeModel,
    request: &ModeRequest,
    progress: &mut dyn FnMut(Progress),
) -> Result<ModeSolution, ModeError> {
    if request.count == 0 {
        return Err(ModeError::NoModesWanted);
    }
    let problem = Problem::new(model, &request.support)?;
    let rigid = RigidModes::new(&problem)?;
    let scale = elastic_scale(&problem, &rigid)?;
    rigid.check_unstrained(scale)?;
    let search = Search { problem: &problem, rigid: &rigid, scale, threads: request.threads };
    let found = search.run(request, progress)?;
    let kind = if problem.held.is_empty() { ModeKind::FreeFree } else { ModeKind::Clamped };
    Ok(search.account(request.count, kind, found))
}

struct Search<'a> {
    problem: &'a Problem<'a>,
    rigid: &'a RigidModes,
    scale: f64,
    threads: usize,
}

struct Found {
    values: Vec<f64>,
    shapes: Mat<f64>,
    limit: CountingShift,
    counted: usize,
    method: String,
    factor_values: usize,
}

impl Search<'_> {
    /// Solves, orthonormalises and counts; widens the search while the count tells that modes are missing.
    fn run(&self, request: &ModeRequest, progress: &mut dyn FnMut(Progress)) -> Result<Found, ModeError> {
        let size = self.problem.dimension();
        let shift = -self.scale;
        progress(Progress { stage: Stage::Ordering, done: 0, total: 1 });
        let shifted = self.problem.shifted_lower(shift)?;
        let node_of: Vec<usize> = self.problem.free.iter().map(|dof| dof / 3).collect();
        let ordering = order(&shifted, &node_of, &self.problem.model.nodes.positions)?;
        let analysis = Analysis::new(&shifted, &ordering.order)?;
        progress(Progress { stage: Stage::Ordering, done: 1, total: 1 });
        let mut shifted = Some(shifted);
        let mut wanted = request.count;
        for _ in 0..ATTEMPTS {
            let dense = self.is_dense(request.method, wanted);
            let pairs = if dense {
                dense::lowest(self.problem, self.rigid, shift, wanted + GUARD)?
            } else {
                let matrix = match shifted.take() {
                    Some(matrix) => matrix,
                    None => self.problem.shifted_lower(shift)?,
                };
                self.iterate(&analysis, matrix, shift, wanted, progress)?
            };
            let (values, shapes) = self.polish(&pairs)?;
            if values.len() < request.count {
                return Err(ModeError::TooFewModes { wanted: request.count, available: values.len() });
            }
            let Some(limit) = counting_shift(&values, request.count, pairs.complete, self.scale) else {
                wanted += GUARD;
                continue;
            };
            progress(Progress { stage: Stage::Counting, done: 0, total: 1 });
            let counted = eigenvalues_below(self.problem, &analysis, limit.shift)?;
            progress(Progress { stage: Stage::Counting, done: 1, total: 1 });
            let expected = limit.below + self.rigid.count();
            if counted == expected {
                let (method, factor_values) = if dense {
                    (format!("dense reduction of {size} degrees of freedom"), 0)
                } else {
                    let values = analysis.stored_values();
                    let method = format!(
                        "shift-inverted block Lanczos on {size} degrees of freedom, factor of {:.1} million values by {}",
                        values as f64 * 1e-6,
                        ordering.method
                    );
                    (method, values)
                };
                return self.settle(Found { values, shapes, limit, counted, method, factor_values });
            }
            if counted < expected || pairs.complete || dense {
                return Err(ModeError::ModesMissed {
                    counted,
                    found: expected,
                    below_hz: hertz(limit.shift),
                });
            }
            wanted += counted - expected;
        }
        Err(ModeError::NoClearGap { wanted })
    }

    fn is_dense(&self, method: Method, wanted: usize) -> bool {
        let size = self.problem.dimension();
        // The iteration needs room for its subspace; where there is none, the dense method is quick.
        let no_room = size < 2 * subspace_size(wanted);
        match method {
            Method::Dense => true,
            Method::Sparse => no_room,
            Method::Automatic => no_room || size <= DENSE_LIMIT,
        }
    }

    /// Factors K - σM and iterates. The factor is gone on return, before eigenvalues are counted by another.
    fn iterate(
        &self,
        analysis: &Analysis,
        shifted: SparseColMat<u32, f64>,
        shift: f64,
        wanted: usize,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Pairs, ModeError> {
        progress(Progress { stage: Stage::Factorising, done: 0, total: 1 });
        let factor = analysis.factorise(&shifted)?;
        drop(shifted);
        progress(Progress { stage: Stage::Factorising, done: 1, total: 1 });
        lanczos::lowest(self.problem, self.rigid, &factor, shift, wanted, self.threads, &mut |done| {
            progress(Progress { stage: Stage::Iterating, done, total: wanted });
        })
    }

    /// Removes what is left of rigid motion, then Rayleigh-Ritz: orthonormal shapes to round-off.
    fn polish(&self, pairs: &Pairs) -> Result<(Vec<f64>, Mat<f64>), ModeError> {
        let mut shapes = pairs.shapes.clone();
        if shapes.ncols() == 0 {
            return Ok((Vec::new(), shapes));
        }
        self.rigid.remove_from(&mut shapes);
        let (values, mut shapes) = rayleigh_ritz(self.problem, &shapes)?;
        self.rigid.remove_from(&mut shapes);
        Ok((values, shapes))
    }

    fn settle(&self, mut found: Found) -> Result<Found, ModeError> {
        settle_repeated(self.problem, &found.values, &mut found.shapes)?;
        settle_signs(&mut found.shapes);
        Ok(found)
    }

    /// Fills the report and keeps the wanted modes.
    fn account(&self, count: usize, kind: ModeKind, found: Found) -> ModeSolution {
        let kept = found.shapes.get(.., 0..count).to_owned();
        let mass_kept = self.problem.mass_times(kept.as_ref());
        let forces = self.problem.stiffness_times(kept.as_ref());
        let shapes = self.problem.expand(kept.as_ref());
        let participation = participation(
            self.problem.model,
            shapes.as_ref(),
            super::problem::mass_times_full(&self.problem.model.mass, &shapes).as_ref(),
        );
        let zero = ZERO * self.scale;
        let entries: Vec<ModeEntry> = (0..count)
            .map(|j| {
                let value = found.values[j];
                let difference =
                    Mat::from_fn(kept.nrows(), 1, |i, _| forces[(i, j)] - value * mass_kept[(i, j)]);
                let norm = column_norm(forces.as_ref(), j);
                let residual = column_norm(difference.as_ref(), 0);
                ModeEntry {
                    number: j + 1,
                    kind,
                    frequency_hz: Some(if value.abs() < zero { 0.0 } else { hertz(value) }),
                    residual: Some(if norm > 0.0 { residual / norm } else { 0.0 }),
                    effective_mass: participation.mass[j],
                    effective_inertia: participation.inertia[j],
                }
            })
            .collect();
        let modes = entries.iter().map(|entry| Mode { kind, frequency_hz: entry.frequency_hz }).collect();
        let rigid_modes = self
            .rigid
            .rayleigh
            .iter()
            .zip(&self.rigid.residuals)
            .map(|(&value, &residual)| RigidModeEntry { frequency_hz: hertz(value.abs()), residual })
            .collect();
        let report = ModeReport {
            method: found.method,
            rigid_modes,
            mechanisms: found.values[..count].iter().filter(|value| value.abs() < zero).count(),
            orthogonality_error: orthogonality_error(kept.as_ref(), mass_kept.as_ref()),
            counted: Some(found.counted),
            found: found.limit.below + self.rigid.count(),
            counted_below_hz: Some(hertz(found.limit.shift)),
            cut_repeated: found.limit.below > count,
            total_mass: participation.total_mass,
            total_inertia: participation.total_inertia,
            loose_dofs: self.problem.loose.len(),
            factor_values: found.factor_values,
            modes: entries,
        };
        ModeSolution { basis: ModeBasis { shapes, modes }, report }
    }
}

/// Frequency of an eigenvalue ω²; negative eigenvalues, which only round-off makes, count as zero.
pub(crate) fn hertz(value: f64) -> f64 {
    value.max(0.0).sqrt() / TAU
}
