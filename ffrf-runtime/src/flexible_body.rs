//! What every generated body can do.

use nalgebra::{SMatrix, SVector, Vector3};

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

/// A flexible body with `M` modes and `N` = 6 + `M` velocities, in the scalar type `T`.
///
/// Unknowns are w = [α; ω̇; q̈]: acceleration of the frame origin (inertial, resolved in the body frame),
/// angular acceleration (body frame) and modal accelerations, with
/// `M(q) w + Q(q, ω, q̇) + [0; 0; K q + D q̇] = force`.
/// Every vector is resolved in the body frame. No method allocates or panics.
pub trait FlexibleBody<const M: usize, const N: usize, T = f64> {
    /// Mass matrix M(q). Shape: N x N, symmetric. Source: (203), body-resolved.
    fn mass_matrix(&self, q: &SVector<T, M>) -> SMatrix<T, N, N>;
    /// Quadratic velocity vector Q(q, ω, q̇), on the left-hand side. Shape: N. Source: (209), corrected.
    fn quadratic_velocity(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> SVector<T, N>;
    /// Accelerations [α; ω̇; q̈] under `force`, elastic and damping forces included. Shape: N.
    ///
    /// q̈ is eliminated first; the dense mass matrix is never formed.
    fn forward_dynamics(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        force: &SVector<T, N>,
    ) -> SVector<T, N>;
    /// Mass matrix, quadratic velocity vector and accelerations in one pass.
    fn equations_of_motion(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        force: &SVector<T, N>,
    ) -> EquationsOfMotion<M, N, T>;
    /// Kinetic energy; `velocity` is that of the frame origin. Units: J.
    fn kinetic_energy(
        &self,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> T;
    /// Elastic energy ½ qᵀ K q. Units: J.
    fn elastic_energy(&self, q: &SVector<T, M>) -> T;
    /// Linear momentum. Shape: 3. Units: N s.
    fn linear_momentum(
        &self,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> Vector3<T>;
    /// Angular momentum about the frame origin. Shape: 3. Units: N m s.
    fn angular_momentum(
        &self,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> Vector3<T>;
    /// Elastic and damping forces K q + D q̇, on the left-hand side. Shape: M.
    fn internal_force(&self, q: &SVector<T, M>, q_dot: &SVector<T, M>) -> SVector<T, M>;
    /// Generalised force of uniform gravity g (body-resolved). Shape: N.
    fn gravity_force(&self, q: &SVector<T, M>, gravity: &Vector3<T>) -> SVector<T, N>;
    /// Modal stiffness K_ff. Shape: M x M.
    fn stiffness_matrix(&self) -> SMatrix<T, M, M>;
    /// Modal damping D_ff. Shape: M x M.
    fn damping_matrix(&self) -> SMatrix<T, M, M>;
}
