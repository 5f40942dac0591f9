//! The sparse solver: shift-inverted block Lanczos with full orthogonalisation and thick restart.
//!
//! The operator (K - σM)⁻¹ M is self-adjoint in the mass inner product; its largest eigenvalues θ belong to the
//! lowest λ = σ + 1/θ. A block finds repeated eigenvalues that a single vector would find only by round-off, and
//! makes each pass over the factor serve several vectors. Rigid motion is projected out of every block.

use faer::{Mat, MatRef, Par};

use super::ModeError;
use super::block::{gram, product, subtract_product, symmetric_eigen};
use super::dense::Pairs;
use super::factor::Factor;
use super::inertia_count::counting_shift;
use super::problem::Problem;
use super::random::Random;
use super::rigid::RigidModes;

/// Vectors per block: at least the multiplicities that symmetric parts have, and two halves that fill the
/// four columns of the dense kernels.
pub(crate) const BLOCK: usize = 8;
/// Residual of (K - σM)⁻¹ M φ = θ φ, relative to θ, in the mass norm, of the modes to be returned.
const TOLERANCE: f64 = 1e-11;
/// The same of the modes behind them, of which only the eigenvalue is of interest: it is exact to the square.
const LOOSE: f64 = 1e-4;
/// Block solves after which the iteration is given up.
const MAX_SOLVES: usize = 400;
/// Columns that orthogonalisation shrinks below this part of their length are round-off.
const DEPENDENT: f64 = 1e-13;

/// Largest subspace used for `wanted` pairs.
pub(crate) fn subspace_size(wanted: usize) -> usize {
    2 * wanted + 6 * BLOCK
}

/// The lowest elastic eigenpairs, up to the first clear gap behind the `wanted` ones and a little beyond.
///
/// `progress` is told how many pairs have converged.
/// Errors: [`ModeError::NotConverged`], [`ModeError::EigenvaluesNotFound`].
pub(crate) fn lowest(
    problem: &Problem<'_>,
    rigid: &RigidModes,
    factor: &Factor<'_>,
    shift: f64,
    wanted: usize,
    threads: usize,
    progress: &mut dyn FnMut(usize),
) -> Result<Pairs, ModeError> {
    let mut space = Subspace::new(problem, rigid, factor, subspace_size(wanted), threads);
    let mut converged = 0;
    for _ in 0..MAX_SOLVES {
        let residual_factor = space.extend();
        let ritz = space.ritz(&residual_factor)?;
        converged = ritz.converged(TOLERANCE);
        progress(converged.min(wanted));
        let seen = ritz.converged(LOOSE);
        let values: Vec<f64> = ritz.values[..seen].iter().map(|theta| shift + theta.recip()).collect();
        if counting_shift(&values, wanted, false, shift.abs()).is_some_and(|limit| limit.below <= converged) {
            let shapes = product(space.active(), ritz.leading(seen).as_ref(), Par::Seq);
            return Ok(Pairs { shapes, complete: false });
        }
        if space.is_full() {
            space.restart(&ritz, seen.max(wanted) + BLOCK);
        }
    }
    Err(ModeError::NotConverged { wanted, converged, solves: MAX_SOLVES })
}

struct Subspace<'a> {
    problem: &'a Problem<'a>,
    rigid: &'a RigidModes,
    factor: &'a Factor<'a>,
    random: Random,
    /// Mass-orthonormal vectors V; the last block is not yet multiplied by the operator.
    basis: Mat<f64>,
    /// M V.
    mass_basis: Mat<f64>,
    /// Vᵀ M (K - σM)⁻¹ M V, upper triangle, for the first `active` vectors.
    projected: Mat<f64>,
    active: usize,
    capacity: usize,
    threads: usize,
}

impl<'a> Subspace<'a> {
    fn new(
        problem: &'a Problem<'a>,
        rigid: &'a RigidModes,
        factor: &'a Factor<'a>,
        capacity: usize,
        threads: usize,
    ) -> Self {
        let size = problem.dimension();
        let mut space = Self {
            problem,
            rigid,
            factor,
            random: Random::new(),
            basis: Mat::zeros(size, capacity + BLOCK),
            mass_basis: Mat::zeros(size, capacity + BLOCK),
            projected: Mat::zeros(capacity, capacity),
            active: 0,
            capacity,
            threads,
        };
        let mut start = Mat::from_fn(size, BLOCK, |_, _| 0.0);
        for j in 0..BLOCK {
            space.random.fill(start.col_as_slice_mut(j));
        }
        let start = space.apply(problem.mass_times(start.as_ref()));
        space.append(start, 0);
        space
    }

    /// The vectors that span the Ritz space.
    fn active(&self) -> MatRef<'_, f64> {
        self.basis.get(.., 0..self.active)
    }

    fn is_full(&self) -> bool {
        self.active + BLOCK > self.capacity
    }

    /// (K - σM)⁻¹ B, free of rigid motion.
    fn apply(&self, mut block: Mat<f64>) -> Mat<f64> {
        self.factor.solve_in_place(block.as_mut(), self.threads);
        self.rigid.remove_from(&mut block);
        block
    }

    /// Multiplies the last block by the operator and appends what is new; returns the factor B of the residual
    /// block V_{j+1} B.
    fn extend(&mut self) -> Mat<f64> {
        let first = self.active;
        let block = self.apply(self.mass_basis.get(.., first..first + BLOCK).to_owned());
        self.active += BLOCK;
        self.append(block, self.active)
    }

    /// Orthonormalises `block` against the first `known` vectors and within itself, and stores it behind them.
    fn append(&mut self, mut block: Mat<f64>, known: usize) -> Mat<f64> {
        let mut removed = [0.0; BLOCK];
        for _ in 0..2 {
            let coefficients = gram(self.mass_basis.get(.., 0..known), block.as_ref(), Par::Seq);
            subtract_product(block.as_mut(), self.basis.get(.., 0..known), coefficients.as_ref(), Par::Seq);
            for j in 0..BLOCK.min(known) {
                for i in 0..known {
                    self.projected[(i, known - BLOCK + j)] += coefficients[(i, j)];
                    removed[j] += coefficients[(i, j)].powi(2);
                }
            }
        }
        let mut residual_factor = Mat::zeros(BLOCK, BLOCK);
        for j in 0..BLOCK {
            let mut column = block.get(.., j..j + 1).to_owned();
            for _ in 0..2 {
                for i in 0..j {
                    let factor = self.orthogonalise_against(&mut column, known + i);
                    residual_factor[(i, j)] += factor;
                    removed[j] += factor.powi(2);
                }
            }
            let mut mass_column = self.problem.mass_times(column.as_ref());
            let mut length = dot(column.col_as_slice(0), mass_column.col_as_slice(0)).max(0.0).sqrt();
            if length > DEPENDENT * removed[j].sqrt() && length > 0.0 {
                residual_factor[(j, j)] = length;
            } else {
                (column, mass_column, length) = self.fresh_column(known + j);
            }
            let scale = length.recip();
            let store = known + j;
            for (target, value) in self.basis.col_as_slice_mut(store).iter_mut().zip(column.col_as_slice(0)) {
                *target = value * scale;
            }
            for (target, value) in
                self.mass_basis.col_as_slice_mut(store).iter_mut().zip(mass_column.col_as_slice(0))
            {
                *target = value * scale;
            }
        }
        residual_factor
    }

    /// A new direction, when the block has none left: the subspace is invariant, or nearly.
    fn fresh_column(&mut self, known: usize) -> (Mat<f64>, Mat<f64>, f64) {
        let mut column = Mat::zeros(self.problem.dimension(), 1);
        self.random.fill(column.col_as_slice_mut(0));
        let mut column = self.apply(self.problem.mass_times(column.as_ref()));
        for _ in 0..2 {
            self.rigid.remove_from(&mut column);
            for i in 0..known {
                self.orthogonalise_against(&mut column, i);
            }
        }
        let mass_column = self.problem.mass_times(column.as_ref());
        let length = dot(column.col_as_slice(0), mass_column.col_as_slice(0)).max(f64::MIN_POSITIVE).sqrt();
        (column, mass_column, length)
    }

    fn orthogonalise_against(&self, column: &mut Mat<f64>, index: usize) -> f64 {
        let factor = dot(self.mass_basis.col_as_slice(index), column.col_as_slice(0));
        for (x, v) in column.col_as_slice_mut(0).iter_mut().zip(self.basis.col_as_slice(index)) {
            *x -= factor * v;
        }
        factor
    }

    /// Ritz pairs in descending order of θ, with residuals.
    fn ritz(&self, residual_factor: &Mat<f64>) -> Result<Ritz, ModeError> {
        let count = self.active;
        let projected = Mat::from_fn(count, count, |i, j| self.projected[(i.min(j), i.max(j))]);
        let (values, vectors) = symmetric_eigen(projected.as_ref())?;
        let values: Vec<f64> = values.into_iter().rev().collect();
        let vectors = Mat::from_fn(count, count, |i, j| vectors[(i, count - 1 - j)]);
        let last = product(residual_factor.as_ref(), vectors.get(count - BLOCK..count, ..), Par::Seq);
        let residuals = (0..count).map(|j| last.col(j).norm_l2()).collect();
        Ok(Ritz { values, vectors, residuals })
    }

    /// Keeps the leading Ritz vectors and the residual block.
    fn restart(&mut self, ritz: &Ritz, keep: usize) {
        let keep = keep.min(self.active - BLOCK);
        let coefficients = ritz.leading(keep);
        for matrix in [&mut self.basis, &mut self.mass_basis] {
            let rotated = product(matrix.get(.., 0..self.active), coefficients.as_ref(), Par::Seq);
            let residual = matrix.get(.., self.active..self.active + BLOCK).to_owned();
            for j in 0..keep {
                matrix.col_as_slice_mut(j).copy_from_slice(rotated.col_as_slice(j));
            }
            for j in 0..BLOCK {
                matrix.col_as_slice_mut(keep + j).copy_from_slice(residual.col_as_slice(j));
            }
        }
        self.projected.fill(0.0);
        for j in 0..keep {
            self.projected[(j, j)] = ritz.values[j];
        }
        self.active = keep;
    }
}

struct Ritz {
    /// θ, descending.
    values: Vec<f64>,
    vectors: Mat<f64>,
    residuals: Vec<f64>,
}

impl Ritz {
    /// How many leading pairs have residuals below `tolerance`.
    fn converged(&self, tolerance: f64) -> usize {
        self.values
            .iter()
            .zip(&self.residuals)
            .take_while(|&(&theta, &residual)| theta > 0.0 && residual <= tolerance * theta)
            .count()
    }

    fn leading(&self, count: usize) -> Mat<f64> {
        self.vectors.get(.., 0..count).to_owned()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
