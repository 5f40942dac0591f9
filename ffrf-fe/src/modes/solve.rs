//! From a request to modes: choose a solver, check what it found, tell about it.

use faer::sparse::SparseColMat;

use crate::{FeError, FeModel};

use super::ModeError;
use super::account::{Found, account, hertz};
use super::canonical::{REPEATED, settle_repeated, settle_signs};
use super::dense::{self, Pairs};
use super::factor::Analysis;
use super::inertia_count::{counting_shift, eigenvalues_below};
use super::lanczos::{self, Known, subspace_size};
use super::operator::ShiftInverted;
use super::ordering::order;
use super::polish::polish;
use super::problem::Problem;
use super::rigid::RigidModes;
use super::scale::elastic_scale;
use super::{Method, ModeRequest, ModeSolution, Progress, Stage};

/// Largest problem that [`Method::Automatic`] solves densely: there both methods take about a second.
const DENSE_LIMIT: usize = 900;
/// Modes that the dense method returns beyond the wanted ones, to see the gap that follows.
const GUARD: usize = 4;
/// How often a search is widened before it is given up.
const ATTEMPTS: usize = 6;

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
    let problem = Problem::new(model, &request.support, request.threads)?;
    let rigid = RigidModes::new(&problem)?;
    let available = rigid.most_elastic(&problem);
    if request.count > available {
        return Err(ModeError::TooFewModes { wanted: request.count, available });
    }
    let scale = elastic_scale(&problem, &rigid)?;
    rigid.check_unstrained(scale)?;
    let search = Search { problem: &problem, rigid: &rigid, scale };
    let found = search.run(request, progress)?;
    Ok(account(&problem, &rigid, scale, request.count, found))
}

struct Search<'a> {
    problem: &'a Problem<'a>,
    rigid: &'a RigidModes,
    scale: f64,
}

impl Search<'_> {
    /// Solves, orthonormalises and counts; searches on beside the modes found while the count tells that some are
    /// missing.
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
        let mut known = None;
        let mut wanted = request.count;
        for attempt in 0..ATTEMPTS {
            let dense = self.is_dense(request.method, wanted);
            let pairs = if dense {
                dense::lowest(self.problem, self.rigid, shift, wanted + GUARD)?
            } else {
                let matrix = match shifted.take() {
                    Some(matrix) => matrix,
                    None => self.problem.shifted_lower(shift)?,
                };
                self.iterate(&analysis, matrix, shift, wanted, known.take(), progress)?
            };
            let complete = pairs.complete;
            let (values, mut shapes) = polish(self.problem, self.rigid, pairs.shapes)?;
            if values.len() < request.count {
                return Err(ModeError::TooFewModes { wanted: request.count, available: values.len() });
            }
            let Some(limit) = counting_shift(&values, request.count, complete, self.scale) else {
                wanted += GUARD << attempt;
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
                let last = values[request.count - 1];
                let cut_repeated =
                    values.get(request.count).is_some_and(|next| next - last <= REPEATED * next.abs());
                settle_repeated(self.problem, &values, &mut shapes)?;
                settle_signs(&mut shapes);
                return Ok(Found { values, shapes, limit, counted, method, factor_values, cut_repeated });
            }
            if counted < expected || complete || dense {
                return Err(ModeError::ModesMissed {
                    counted,
                    found: expected,
                    below_hz: hertz(limit.shift),
                });
            }
            shapes.truncate(size, limit.below);
            known = Some(Known { shapes, values: values[..limit.below].to_vec() });
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
        known: Option<Known>,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Pairs, ModeError> {
        progress(Progress { stage: Stage::Factorising, done: 0, total: 1 });
        let factor = analysis.factorise(&shifted)?;
        drop(shifted);
        progress(Progress { stage: Stage::Factorising, done: 1, total: 1 });
        let operator = ShiftInverted { problem: self.problem, rigid: self.rigid, factor: &factor, shift };
        lanczos::lowest(&operator, wanted, known, &mut |done| {
            progress(Progress { stage: Stage::Iterating, done, total: wanted });
        })
    }
}
