//! The sparse solver: shift-inverted block Lanczos with full orthogonalisation, locking and thick restart.
//!
//! A block finds repeated eigenvalues that a single vector would find only by round-off, and makes each pass over
//! the factor serve several vectors. Pairs that have converged are locked at the next restart: they take no further
//! part in the projected problem, so that its round-off is relative to the pairs that are still sought.
//! (Wu, Simon: Thick-restart Lanczos method for large symmetric eigenvalue problems, SIAM J. Matrix Anal. Appl. 22,
//! 2000; Grimes, Lewis, Simon: A shifted block Lanczos algorithm, SIAM J. Matrix Anal. Appl. 15, 1994.)

use faer::Mat;

use super::ModeError;
use super::dense::Pairs;
use super::inertia_count::counting_shift;
use super::operator::Operator;
use super::subspace::{BLOCK, Ritz, Subspace};

/// Residual of (K - σM)⁻¹ M φ = θ φ, relative to θ, in the mass norm, of the modes to be returned.
const TOLERANCE: f64 = 1e-11;
/// The same of the modes behind them, of which only the eigenvalue is of interest: it is exact to the square.
const LOOSE: f64 = 1e-4;
/// θ below this part of the largest are round-off of zero: motions without mass.
const VANISHED: f64 = 1e-13;
/// Restarts after which the iteration is given up: each gains several digits, unless something is wrong.
const MAX_RESTARTS: usize = 60;

/// Largest subspace used for `wanted` pairs.
pub(crate) fn subspace_size(wanted: usize) -> usize {
    wanted + wanted.min(128) + 6 * BLOCK
}

/// Eigenvectors of an earlier search, with their eigenvalues λ.
pub(crate) struct Known {
    pub shapes: Mat<f64>,
    pub values: Vec<f64>,
}

/// The lowest elastic eigenpairs, up to the first clear gap behind the `wanted` ones and a little beyond.
///
/// `known` pairs are returned along with those found beside them. `progress` is told how many pairs have converged.
/// Errors: [`ModeError::NotConverged`], [`ModeError::EigenvaluesNotFound`], [`ModeError::SubspaceTooLarge`].
pub(crate) fn lowest(
    operator: &dyn Operator,
    wanted: usize,
    known: Option<Known>,
    progress: &mut dyn FnMut(usize),
) -> Result<Pairs, ModeError> {
    let size = operator.size();
    let known = known.unwrap_or_else(|| Known { shapes: Mat::zeros(size, 0), values: Vec::new() });
    let known_values = known.values.iter().map(|value| (value - operator.shift()).recip()).collect();
    let capacity = subspace_size(wanted.max(known.values.len()));
    let mut space = Subspace::new(operator, known.shapes.as_ref(), known_values, capacity)?;
    drop(known);
    let mut converged = 0;
    let mut restarts = 0;
    while restarts <= MAX_RESTARTS {
        let residual_factor = space.extend();
        progress(converged.min(wanted));
        if space.dimension() < wanted && !space.is_full() && !space.is_exhausted() {
            continue;
        }
        let ritz = space.ritz(&residual_factor)?;
        if space.is_exhausted() || ritz.has_all(TOLERANCE) {
            let count = ritz.finite(VANISHED);
            return Ok(Pairs { shapes: space.into_shapes(&ritz, count), complete: true });
        }
        converged = space.locked().len() + ritz.converged(TOLERANCE);
        progress(converged.min(wanted));
        let seen = ritz.converged(LOOSE);
        if is_complete(operator, &space, &ritz, wanted) {
            return Ok(Pairs { shapes: space.into_shapes(&ritz, seen), complete: false });
        }
        if space.is_full() {
            restarts += 1;
            let (lock, keep) = kept(&space, &ritz, wanted, capacity);
            space.restart(&ritz, lock, keep);
        }
    }
    Err(ModeError::NotConverged { wanted, converged, restarts })
}

/// True if every pair below the first clear gap behind the wanted ones has converged.
fn is_complete(operator: &dyn Operator, space: &Subspace<'_>, ritz: &Ritz, wanted: usize) -> bool {
    let active = &ritz.values[..ritz.converged(LOOSE)];
    let mut values: Vec<f64> =
        space.locked().iter().chain(active).map(|&theta| operator.eigenvalue(theta)).collect();
    values.sort_by(f64::total_cmp);
    let Some(limit) = counting_shift(&values, wanted, false, operator.shift().abs()) else { return false };
    match ritz.values.get(ritz.converged(TOLERANCE)) {
        Some(&open) => open <= 0.0 || operator.eigenvalue(open) > limit.shift,
        None => false,
    }
}

/// How many leading Ritz vectors to lock at a restart, and how many to keep, locked ones included.
///
/// Of the room beyond the wanted pairs, half goes to pairs behind them, half to new directions.
fn kept(space: &Subspace<'_>, ritz: &Ritz, wanted: usize, capacity: usize) -> (usize, usize) {
    let locked = space.locked().len();
    let most = wanted + capacity.saturating_sub(wanted) / 2;
    let total = (locked + ritz.converged(LOOSE)).max(wanted) + BLOCK;
    let keep = total.min(most).saturating_sub(locked).min(ritz.values.len());
    (ritz.converged(TOLERANCE).min(keep), keep)
}
