//! The dense N x N form of the equations of motion, for users and tests; mechanisms do not need it.

use nalgebra::{RealField, SMatrix, SVector, Vector3};

use super::FlexibleBody;

/// Mass matrix, quadratic velocity vector and accelerations of one state, from one pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EquationsOfMotion<const M: usize, const N: usize, T = f64> {
    /// Mass matrix M(q). Shape: N x N.
    pub mass_matrix: SMatrix<T, N, N>,
    /// Quadratic velocity vector Q(q, ω, q̇). Shape: N.
    pub quadratic_velocity: SVector<T, N>,
    /// Accelerations [α; ω̇; q̈]. Shape: N.
    pub acceleration: SVector<T, N>,
}

impl<const M: usize, const N: usize, T: RealField + Copy> EquationsOfMotion<M, N, T> {
    /// Zero everywhere: places to write to.
    #[inline]
    pub fn zeros() -> Self {
        Self {
            mass_matrix: SMatrix::zeros(),
            quadratic_velocity: SVector::zeros(),
            acceleration: SVector::zeros(),
        }
    }
}

/// The equations of motion of a body with `M` modes and `N` = 6 + `M` velocities as dense matrices.
pub trait DenseForms<const M: usize, const N: usize, T: RealField + Copy = f64>:
    FlexibleBody<T, Modal = SVector<T, M>>
{
    /// Mass matrix M(q). Shape: N x N, symmetric. Source: (203), body-resolved.
    fn mass_matrix(&self, q: &SVector<T, M>) -> SMatrix<T, N, N> {
        const { assert!(N == 6 + M, "a body with M modes has N = 6 + M velocities") };
        let rest = SVector::zeros();
        let prepared = self.prepare(q, &Vector3::zeros(), &rest);
        let rigid = prepared.rigid_mass();
        let modal = self.modal_mass().dense();
        let coupling = prepared.coupling();
        SMatrix::from_fn(|i, j| match (i < 6, j < 6) {
            (true, true) => rigid[(i, j)],
            (true, false) => coupling[i][j - 6],
            (false, true) => coupling[j][i - 6],
            (false, false) => modal[(i - 6, j - 6)],
        })
    }

    /// Quadratic velocity vector Q(q, ω, q̇), on the left-hand side. Shape: N. Source: (209), corrected.
    fn quadratic_velocity(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> SVector<T, N> {
        self.prepare(q, omega, q_dot).quadratic_velocity.to_vector()
    }

    /// Mass matrix, quadratic velocity vector and accelerations in one pass.
    fn equations_of_motion(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        force: &SVector<T, N>,
    ) -> EquationsOfMotion<M, N, T> {
        let force = super::GeneralisedForce::from_vector(force);
        EquationsOfMotion {
            mass_matrix: self.mass_matrix(q),
            quadratic_velocity: self.quadratic_velocity(q, omega, q_dot),
            acceleration: self.forward_dynamics(q, omega, q_dot, &force).to_vector(),
        }
    }

    /// [`DenseForms::equations_of_motion`] into given places: with many modes, moving the matrix costs as much as
    /// computing it.
    #[allow(clippy::too_many_arguments)] // inputs and outputs, each in its place
    fn write_equations_of_motion(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        force: &SVector<T, N>,
        mass_matrix: &mut SMatrix<T, N, N>,
        quadratic_velocity: &mut SVector<T, N>,
        acceleration: &mut SVector<T, N>,
    ) {
        let equations = self.equations_of_motion(q, omega, q_dot, force);
        *mass_matrix = equations.mass_matrix;
        *quadratic_velocity = equations.quadratic_velocity;
        *acceleration = equations.acceleration;
    }

    /// Modal stiffness K_ff. Shape: M x M.
    fn stiffness_matrix(&self) -> SMatrix<T, M, M> {
        self.stiffness().dense()
    }

    /// Modal damping D_ff. Shape: M x M.
    fn damping_matrix(&self) -> SMatrix<T, M, M> {
        self.damping().dense()
    }
}
