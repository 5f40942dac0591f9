//! The operator whose largest eigenvalues belong to the lowest modes.

use faer::{Mat, MatRef};

use super::factor::Factor;
use super::problem::Problem;
use super::random::Random;
use super::rigid::RigidModes;

/// (K - σM)⁻¹ M on the complement of rigid motion: self-adjoint in the mass inner product, with eigenvalues
/// θ = 1 / (λ - σ).
pub(crate) struct Operator<'a> {
    /// K and M.
    pub problem: &'a Problem<'a>,
    /// The motions that are projected out.
    pub rigid: &'a RigidModes,
    /// Factor of K - σM.
    pub factor: &'a Factor<'a>,
    /// σ, below every eigenvalue. Units: (rad/s)².
    pub shift: f64,
}

impl Operator<'_> {
    /// The operator on X, given B = M X.
    pub fn apply(&self, mass_block: MatRef<'_, f64>) -> Mat<f64> {
        let mut block = mass_block.to_owned();
        self.factor.solve_in_place(block.as_mut(), self.problem.threads);
        self.rigid.remove_from(&mut block);
        block
    }

    /// Vectors in the range of the operator that favour no mode.
    pub fn start(&self, random: &mut Random, columns: usize) -> Mat<f64> {
        let mut block = Mat::zeros(self.problem.dimension(), columns);
        for j in 0..columns {
            random.fill(block.col_as_slice_mut(j));
        }
        self.apply(self.problem.mass_times(block.as_ref()).as_ref())
    }

    /// λ of θ.
    pub fn eigenvalue(&self, theta: f64) -> f64 {
        self.shift + theta.recip()
    }
}
