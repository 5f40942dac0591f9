//! Analytic Jacobians, which a generated body has on request (`jacobians: true`).

use nalgebra::{RealField, SMatrix, SVector, Vector3};

use crate::DenseForms;

/// Accelerations w = [α; ω̇; q̈] and their derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AccelerationJacobian<const M: usize, const N: usize, T = f64> {
    /// Accelerations w. Shape: N.
    pub acceleration: SVector<T, N>,
    /// ∂w/∂q. Shape: N x M.
    pub coordinates: SMatrix<T, N, M>,
    /// ∂w/∂q̇. Shape: N x M.
    pub rates: SMatrix<T, N, M>,
    /// ∂w/∂ω. Shape: N x 3.
    pub angular_velocity: SMatrix<T, N, 3>,
    /// ∂w/∂force = M(q)⁻¹. Shape: N x N, symmetric.
    pub force: SMatrix<T, N, N>,
}

impl<const M: usize, const N: usize, T: RealField + Copy> AccelerationJacobian<M, N, T> {
    /// ∂w/∂v = 0: the equations do not depend on the velocity of the frame origin. Shape: N x 3.
    pub fn velocity(&self) -> SMatrix<T, N, 3> {
        SMatrix::zeros()
    }
}

/// Residual R = M(q) w + Q(q, ω, q̇) + [0; 0; K q + D q̇] - force and its derivatives at constant w.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResidualJacobian<const M: usize, const N: usize, T = f64> {
    /// Residual R. Shape: N. Units: N, N m, modal forces.
    pub residual: SVector<T, N>,
    /// ∂R/∂q. Shape: N x M.
    pub coordinates: SMatrix<T, N, M>,
    /// ∂R/∂q̇. Shape: N x M.
    pub rates: SMatrix<T, N, M>,
    /// ∂R/∂ω. Shape: N x 3.
    pub angular_velocity: SMatrix<T, N, 3>,
    /// ∂R/∂w = M(q). Shape: N x N, symmetric.
    pub acceleration: SMatrix<T, N, N>,
}

impl<const M: usize, const N: usize, T: RealField + Copy> ResidualJacobian<M, N, T> {
    /// ∂R/∂v = 0: the equations do not depend on the velocity of the frame origin. Shape: N x 3.
    pub fn velocity(&self) -> SMatrix<T, N, 3> {
        SMatrix::zeros()
    }

    /// ∂R/∂force = -I. Shape: N x N.
    pub fn force(&self) -> SMatrix<T, N, N> {
        -SMatrix::identity()
    }
}

/// A flexible body that knows the derivatives of its equations.
///
/// Forces are independent variables: where they depend on the state themselves, the chain rule is the caller's.
pub trait FlexibleBodyJacobians<const M: usize, const N: usize, T: RealField + Copy = f64>:
    DenseForms<M, N, T>
{
    /// Accelerations under `force` and their derivatives. Panics: never.
    fn acceleration_jacobian(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        force: &SVector<T, N>,
    ) -> AccelerationJacobian<M, N, T>;
    /// Residual for given accelerations and force, and its derivatives. Panics: never.
    fn residual_jacobian(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        acceleration: &SVector<T, N>,
        force: &SVector<T, N>,
    ) -> ResidualJacobian<M, N, T>;
}
