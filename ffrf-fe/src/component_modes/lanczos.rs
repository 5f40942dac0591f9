//! The lowest normal modes by block Lanczos on the flexibility, with full orthogonalisation and without restart.
//!
//! The flexibility keeps every vector admissible: free of rigid motion, or with the interfaces at rest.

use faer::{Mat, Par};

use crate::FeError;
use crate::modes::{Random, gram, product, subtract_product};

use super::ComponentModeError;
use super::condition::Condition;
use super::jacobi;

/// Vectors per block: at least the multiplicities that symmetric parts have.
const BLOCK: usize = 8;
/// Residual of G M y = θ y relative to θ, in the mass norm: the eigenvalue is exact to the square.
const TOLERANCE: f64 = 1e-10;
/// Columns that orthogonalisation shrinks below this part of their length are round-off.
const DEPENDENT: f64 = 1e-13;

/// Vectors after which the iteration is given up.
pub(crate) fn subspace_size(wanted: usize) -> usize {
    4 * wanted + 12 * BLOCK
}

/// The lowest `wanted` eigenvalues ω² and shapes with unit modal mass.
///
/// Errors: [`ComponentModeError::NotConverged`].
pub(crate) fn lowest(
    condition: Condition<'_>,
    wanted: usize,
    progress: &mut dyn FnMut(usize),
) -> Result<(Vec<f64>, Mat<f64>), FeError> {
    let capacity = subspace_size(wanted).next_multiple_of(BLOCK);
    let mut space = Subspace::new(condition, capacity);
    let mut converged = 0;
    while space.active + BLOCK <= capacity {
        let residual = space.extend();
        if space.active < wanted {
            continue;
        }
        let (values, vectors) = jacobi::eigen(space.projected.get(..space.active, ..space.active))?;
        let count = values.len();
        let last = product(residual.as_ref(), vectors.get(count - BLOCK.., ..), Par::Seq);
        // Eigenvalues of the flexibility, the largest last.
        converged = (0..count)
            .rev()
            .take_while(|&j| values[j] > 0.0 && last.col(j).norm_l2() <= TOLERANCE * values[j])
            .count();
        progress(converged.min(wanted));
        if converged >= wanted {
            let chosen = Mat::from_fn(count, wanted, |i, j| vectors[(i, count - 1 - j)]);
            let shapes = product(space.basis.get(.., ..count), chosen.as_ref(), Par::Seq);
            return Ok((values.iter().rev().take(wanted).map(|theta| theta.recip()).collect(), shapes));
        }
    }
    Err(ComponentModeError::NotConverged { wanted, converged, subspace: space.active }.into())
}

struct Subspace<'a> {
    condition: Condition<'a>,
    /// Mass-orthonormal vectors; the last block is not yet multiplied by the flexibility.
    basis: Mat<f64>,
    mass_basis: Mat<f64>,
    /// Lower triangle of VᵀM G M V for the first `active` vectors.
    projected: Mat<f64>,
    active: usize,
    random: Random,
}

impl<'a> Subspace<'a> {
    fn new(condition: Condition<'a>, capacity: usize) -> Self {
        let size = condition.coordinates().dimension();
        let mut space = Self {
            condition,
            basis: Mat::zeros(size, capacity + BLOCK),
            mass_basis: Mat::zeros(size, capacity + BLOCK),
            projected: Mat::zeros(capacity + BLOCK, capacity + BLOCK),
            active: 0,
            random: Random::new(),
        };
        let mut start = Mat::zeros(size, BLOCK);
        for j in 0..BLOCK {
            space.random.fill(start.col_as_slice_mut(j));
        }
        let start = space.apply(&start);
        space.append(start, 0);
        space
    }

    /// G M Y.
    fn apply(&self, shapes: &Mat<f64>) -> Mat<f64> {
        self.condition.flexibility_times(self.condition.coordinates().mass_times(shapes.as_ref()))
    }

    /// Multiplies the last block and appends what is new; returns the factor of the residual block.
    fn extend(&mut self) -> Mat<f64> {
        let first = self.active;
        let block =
            self.condition.flexibility_times(self.mass_basis.get(.., first..first + BLOCK).to_owned());
        self.active += BLOCK;
        self.append(block, self.active)
    }

    /// Orthonormalises `block` against the first `known` vectors and within itself, and stores it behind them.
    fn append(&mut self, mut block: Mat<f64>, known: usize) -> Mat<f64> {
        let mut removed = [0.0; BLOCK];
        for _ in 0..2 {
            let factors = gram(self.mass_basis.get(.., ..known), block.as_ref(), Par::Seq);
            subtract_product(block.as_mut(), self.basis.get(.., ..known), factors.as_ref(), Par::Seq);
            for j in 0..BLOCK {
                for i in 0..known {
                    // Row and column of the block that was multiplied.
                    let (row, column) = (known - BLOCK + j, i);
                    if row >= column {
                        self.projected[(row, column)] += factors[(i, j)];
                    }
                    removed[j] += factors[(i, j)].powi(2);
                }
            }
        }
        let mut residual = Mat::zeros(BLOCK, BLOCK);
        for j in 0..BLOCK {
            let mut column = block.get(.., j..j + 1).to_owned();
            for _ in 0..2 {
                for i in 0..j {
                    let factor = self.orthogonalise(&mut column, known + i);
                    residual[(i, j)] += factor;
                    removed[j] += factor.powi(2);
                }
            }
            let mut mass_column = self.condition.coordinates().mass_times(column.as_ref());
            let mut length = norm(&column, &mass_column);
            if length > DEPENDENT * removed[j].sqrt() && length > 0.0 {
                residual[(j, j)] = length;
            } else {
                // The subspace is invariant, or nearly: a new direction takes the place.
                (column, mass_column, length) = self.fresh(known + j);
            }
            for (matrix, source) in [(&mut self.basis, &column), (&mut self.mass_basis, &mass_column)] {
                for (target, value) in
                    matrix.col_as_slice_mut(known + j).iter_mut().zip(source.col_as_slice(0))
                {
                    *target = value / length;
                }
            }
        }
        residual
    }

    fn fresh(&mut self, known: usize) -> (Mat<f64>, Mat<f64>, f64) {
        let mut column = Mat::zeros(self.basis.nrows(), 1);
        self.random.fill(column.col_as_slice_mut(0));
        let mut column = self.apply(&column);
        for _ in 0..2 {
            for i in 0..known {
                self.orthogonalise(&mut column, i);
            }
        }
        let mass_column = self.condition.coordinates().mass_times(column.as_ref());
        let length = norm(&column, &mass_column).max(f64::MIN_POSITIVE);
        (column, mass_column, length)
    }

    fn orthogonalise(&self, column: &mut Mat<f64>, index: usize) -> f64 {
        let factor = dot(self.mass_basis.col_as_slice(index), column.col_as_slice(0));
        for (x, v) in column.col_as_slice_mut(0).iter_mut().zip(self.basis.col_as_slice(index)) {
            *x -= factor * v;
        }
        factor
    }
}

fn norm(column: &Mat<f64>, mass_column: &Mat<f64>) -> f64 {
    dot(column.col_as_slice(0), mass_column.col_as_slice(0)).max(0.0).sqrt()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
