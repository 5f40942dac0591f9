//! The Krylov space of the sparse solver: its basis, the operator projected onto it, and thick restarts.
//!
//! The basis is [L V V⁺], mass-orthonormal: locked pairs, the active vectors, and the last block, which the operator
//! has not met yet.

use faer::{Mat, MatRef, Par};

use super::ModeError;
use super::block::{product, rotate};
use super::operator::Operator;
use super::orthonormal::orthonormalise_block;
use super::random::Random;
use super::symmetric_eigen::symmetric_eigen;

/// Vectors per block: at least the multiplicities that symmetric parts have, and two halves that fill the
/// four columns of the dense kernels.
pub(crate) const BLOCK: usize = 8;

pub(crate) struct Subspace<'a> {
    operator: &'a dyn Operator,
    random: Random,
    basis: Mat<f64>,
    /// M V⁺.
    last_mass: Mat<f64>,
    /// Vᵀ M (K - σM)⁻¹ M V, upper triangle.
    projected: Mat<f64>,
    /// θ of the locked pairs.
    locked: Vec<f64>,
    active: usize,
    capacity: usize,
}

impl<'a> Subspace<'a> {
    /// A start block beside eigenvectors that are known already, with their θ. At most `capacity` vectors are
    /// multiplied by the operator.
    ///
    /// Errors: [`ModeError::SubspaceTooLarge`].
    pub fn new(
        operator: &'a dyn Operator,
        known: MatRef<'_, f64>,
        known_values: Vec<f64>,
        capacity: usize,
    ) -> Result<Self, ModeError> {
        let size = operator.size();
        let vectors = capacity + BLOCK;
        let mut room: Vec<f64> = Vec::new();
        let too_large = ModeError::SubspaceTooLarge { size, vectors };
        let values = size.checked_mul(vectors).ok_or(too_large.clone())?;
        room.try_reserve_exact(values).map_err(|_| too_large)?;
        drop(room);
        // Memory is reserved at once and touched as the basis grows.
        let mut basis = Mat::with_capacity(size, vectors);
        basis.resize_with(size, known.ncols(), |i, j| known[(i, j)]);
        let mut space = Self {
            operator,
            random: Random::new(),
            basis,
            last_mass: Mat::zeros(size, 0),
            projected: Mat::zeros(capacity, capacity),
            locked: known_values,
            active: 0,
            capacity,
        };
        let start = operator.start(&mut space.random, BLOCK);
        space.append(start);
        Ok(space)
    }

    /// θ of the locked pairs.
    pub fn locked(&self) -> &[f64] {
        &self.locked
    }

    /// Number of vectors that span the Ritz space, locked ones included.
    pub fn dimension(&self) -> usize {
        self.locked.len() + self.active
    }

    /// True if no room is left for another block.
    pub fn is_full(&self) -> bool {
        self.dimension() + BLOCK > self.capacity
    }

    /// True if the space holds every direction that there is.
    pub fn is_exhausted(&self) -> bool {
        self.last_mass.ncols() == 0
    }

    /// Multiplies the last block by the operator and appends what is new; returns the factor B of the residual
    /// block V⁺ B.
    pub fn extend(&mut self) -> Mat<f64> {
        let width = self.last_mass.ncols();
        let block = self.operator.apply(self.last_mass.as_ref());
        let first = self.active;
        self.active += width;
        let (coefficients, residual_factor) = self.append(block);
        let locked = self.locked.len();
        for j in 0..width {
            for i in 0..self.active {
                self.projected[(i, first + j)] = coefficients[(locked + i, j)];
            }
        }
        residual_factor
    }

    /// Orthonormalises a block against the basis and stores it behind; returns its coefficients and B.
    fn append(&mut self, block: Mat<f64>) -> (Mat<f64>, Mat<f64>) {
        let known = self.basis.ncols();
        let new = orthonormalise_block(self.operator, &mut self.random, self.basis.as_ref(), block);
        let columns = known + new.block.ncols();
        self.basis.resize_with(self.basis.nrows(), columns, |i, j| new.block[(i, j - known)]);
        self.last_mass = new.mass_block;
        (new.coefficients, new.residual_factor)
    }

    /// Ritz pairs of the active vectors in descending order of θ, with residuals.
    ///
    /// Errors: [`ModeError::EigenvaluesNotFound`].
    pub fn ritz(&self, residual_factor: &Mat<f64>) -> Result<Ritz, ModeError> {
        let count = self.active;
        let projected = Mat::from_fn(count, count, |i, j| self.projected[(i.min(j), i.max(j))]);
        let (values, vectors) = symmetric_eigen(projected.as_ref())?;
        let values: Vec<f64> = values.into_iter().rev().collect();
        let vectors = Mat::from_fn(count, count, |i, j| vectors[(i, count - 1 - j)]);
        let width = residual_factor.ncols();
        let last = product(residual_factor.as_ref(), vectors.get(count - width..count, ..), Par::Seq);
        let residuals = (0..count).map(|j| last.col(j).norm_l2()).collect();
        let most = self.operator.pairs().saturating_sub(self.locked.len());
        Ok(Ritz { values, vectors, residuals, most })
    }

    /// Keeps `keep` leading Ritz vectors, of which the first `lock` are locked, and the last block.
    pub fn restart(&mut self, ritz: &Ritz, lock: usize, keep: usize) {
        let (first, end) = (self.locked.len(), self.dimension());
        let rotation = ritz.vectors.get(.., 0..keep);
        rotate(self.basis.as_mut().get_mut(.., first..end), rotation, self.operator.threads());
        let columns = self.basis.ncols();
        for j in end..columns {
            let column = self.basis.col_as_slice(j).to_vec();
            self.basis.col_as_slice_mut(first + keep + j - end).copy_from_slice(&column);
        }
        self.basis.truncate(self.basis.nrows(), first + keep + columns - end);
        self.locked.extend_from_slice(&ritz.values[..lock]);
        self.active = keep - lock;
        self.projected.fill(0.0);
        for (j, &theta) in ritz.values[lock..keep].iter().enumerate() {
            self.projected[(j, j)] = theta;
        }
    }

    /// The locked pairs and the first `count` Ritz vectors.
    pub fn into_shapes(mut self, ritz: &Ritz, count: usize) -> Mat<f64> {
        let (first, end) = (self.locked.len(), self.dimension());
        let rotation = ritz.vectors.get(.., 0..count);
        rotate(self.basis.as_mut().get_mut(.., first..end), rotation, self.operator.threads());
        self.basis.truncate(self.basis.nrows(), first + count);
        self.basis
    }
}

/// Ritz pairs of the active part of the space.
pub(crate) struct Ritz {
    /// θ, descending.
    pub values: Vec<f64>,
    vectors: Mat<f64>,
    residuals: Vec<f64>,
    /// Pairs that exist beside the locked ones; what is found beyond is round-off.
    most: usize,
}

impl Ritz {
    /// True if all pairs that exist have residuals below `tolerance`.
    pub fn has_all(&self, tolerance: f64) -> bool {
        self.converged(tolerance) == self.most
    }

    /// How many leading pairs have θ above `part` of the largest.
    pub fn finite(&self, part: f64) -> usize {
        let largest = self.values.first().copied().unwrap_or(0.0);
        self.values.iter().take(self.most).take_while(|&&theta| theta > part * largest).count()
    }

    /// How many leading pairs have residuals below `tolerance`, relative to θ.
    pub fn converged(&self, tolerance: f64) -> usize {
        self.values
            .iter()
            .zip(&self.residuals)
            .take(self.most)
            .take_while(|&(&theta, &residual)| theta > 0.0 && residual <= tolerance * theta)
            .count()
    }
}
