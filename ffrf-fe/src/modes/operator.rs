//! The operator whose largest eigenvalues belong to the lowest modes.

use faer::{Mat, MatRef};

use super::factor::Factor;
use super::problem::Problem;
use super::random::Random;
use super::rigid::RigidModes;

/// (K - σM)⁻¹ M on admissible vectors: self-adjoint in the mass inner product, with eigenvalues θ = 1 / (λ - σ).
pub(crate) trait Operator {
    /// Length of the vectors.
    fn size(&self) -> usize;
    /// Number of eigenpairs with θ above zero.
    fn pairs(&self) -> usize;
    /// σ, below every eigenvalue. Units: (rad/s)².
    fn shift(&self) -> f64;
    /// Threads of the work on tall blocks: 1 or 2.
    fn threads(&self) -> usize;
    /// M X.
    fn mass_times(&self, block: MatRef<'_, f64>) -> Mat<f64>;
    /// The operator on X, given B = M X.
    fn apply(&self, mass_block: MatRef<'_, f64>) -> Mat<f64>;
    /// Takes rigid motion out of X, where the operator does.
    fn remove_rigid(&self, block: &mut Mat<f64>);

    /// Vectors in the range of the operator that favour no mode.
    fn start(&self, random: &mut Random, columns: usize) -> Mat<f64> {
        let mut block = Mat::zeros(self.size(), columns);
        for j in 0..columns {
            random.fill(block.col_as_slice_mut(j));
        }
        self.apply(self.mass_times(block.as_ref()).as_ref())
    }

    /// λ of θ.
    fn eigenvalue(&self, theta: f64) -> f64 {
        self.shift() + theta.recip()
    }
}

/// The operator of a [`Problem`], on the complement of rigid motion.
pub(crate) struct ShiftInverted<'a> {
    /// K and M.
    pub problem: &'a Problem<'a>,
    /// The motions that are projected out.
    pub rigid: &'a RigidModes,
    /// Factor of K - σM.
    pub factor: &'a Factor<'a>,
    /// σ. Units: (rad/s)².
    pub shift: f64,
}

impl Operator for ShiftInverted<'_> {
    fn size(&self) -> usize {
        self.problem.dimension()
    }

    fn pairs(&self) -> usize {
        self.rigid.most_elastic(self.problem)
    }

    fn shift(&self) -> f64 {
        self.shift
    }

    fn threads(&self) -> usize {
        self.problem.threads
    }

    fn mass_times(&self, block: MatRef<'_, f64>) -> Mat<f64> {
        self.problem.mass_times(block)
    }

    fn apply(&self, mass_block: MatRef<'_, f64>) -> Mat<f64> {
        let mut block = mass_block.to_owned();
        self.factor.solve_in_place(block.as_mut(), self.problem.threads);
        self.remove_rigid(&mut block);
        block
    }

    fn remove_rigid(&self, block: &mut Mat<f64>) {
        self.rigid.remove_from(block);
    }
}
