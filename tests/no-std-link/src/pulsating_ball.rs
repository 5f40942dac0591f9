//! A ball with one breathing mode: the smallest flexible body that still couples deformation and spin.

use ffrf::nalgebra::{SMatrix, SVector, Vector3};
use ffrf::{EquationsOfMotion, FlexibleBody};

const MASS: f64 = 2.0;
/// Euler tensor of the undeformed ball, T = S I. Units: kg m².
const S: f64 = 0.4;
const STIFFNESS: f64 = 120.0;

/// Displacement φ = x, so T_μ = T, T_μν = T and everything scales with 1 + q.
pub struct PulsatingBall;

/// Θ_rr = 2 S (1 + q)² I.
fn inertia(q: &SVector<f64, 1>) -> f64 {
    2.0 * S * (1.0 + q[0]) * (1.0 + q[0])
}

impl FlexibleBody<1, 7> for PulsatingBall {
    fn mass_matrix(&self, q: &SVector<f64, 1>) -> SMatrix<f64, 7, 7> {
        let rotation = inertia(q);
        SMatrix::from_diagonal(&SVector::from([MASS, MASS, MASS, rotation, rotation, rotation, 3.0 * S]))
    }

    fn quadratic_velocity(
        &self,
        q: &SVector<f64, 1>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, 1>,
    ) -> SVector<f64, 7> {
        // Θ_μ^d = 2 S (1 + q) I
        let modal_inertia = 2.0 * S * (1.0 + q[0]);
        let rotation = omega * (2.0 * q_dot[0] * modal_inertia);
        let modal = -modal_inertia * omega.dot(omega);
        SVector::from([0.0, 0.0, 0.0, rotation.x, rotation.y, rotation.z, modal])
    }

    fn forward_dynamics(
        &self,
        q: &SVector<f64, 1>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, 1>,
        force: &SVector<f64, 7>,
    ) -> SVector<f64, 7> {
        let mut right = force - self.quadratic_velocity(q, omega, q_dot);
        right[6] -= self.internal_force(q, q_dot)[0];
        right.component_div(&self.mass_matrix(q).diagonal())
    }

    fn equations_of_motion(
        &self,
        q: &SVector<f64, 1>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, 1>,
        force: &SVector<f64, 7>,
    ) -> EquationsOfMotion<1, 7> {
        EquationsOfMotion {
            mass_matrix: self.mass_matrix(q),
            quadratic_velocity: self.quadratic_velocity(q, omega, q_dot),
            acceleration: self.forward_dynamics(q, omega, q_dot, force),
        }
    }

    fn kinetic_energy(
        &self,
        q: &SVector<f64, 1>,
        velocity: &Vector3<f64>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, 1>,
    ) -> f64 {
        0.5 * (MASS * velocity.dot(velocity) + inertia(q) * omega.dot(omega) + 3.0 * S * q_dot[0] * q_dot[0])
    }

    fn elastic_energy(&self, q: &SVector<f64, 1>) -> f64 {
        0.5 * STIFFNESS * q[0] * q[0]
    }

    fn linear_momentum(
        &self,
        _: &SVector<f64, 1>,
        velocity: &Vector3<f64>,
        _: &Vector3<f64>,
        _: &SVector<f64, 1>,
    ) -> Vector3<f64> {
        velocity * MASS
    }

    fn angular_momentum(
        &self,
        q: &SVector<f64, 1>,
        _: &Vector3<f64>,
        omega: &Vector3<f64>,
        _: &SVector<f64, 1>,
    ) -> Vector3<f64> {
        omega * inertia(q)
    }

    fn internal_force(&self, q: &SVector<f64, 1>, _: &SVector<f64, 1>) -> SVector<f64, 1> {
        q * STIFFNESS
    }

    fn gravity_force(&self, _: &SVector<f64, 1>, gravity: &Vector3<f64>) -> SVector<f64, 7> {
        let weight = gravity * MASS;
        SVector::from([weight.x, weight.y, weight.z, 0.0, 0.0, 0.0, 0.0])
    }

    fn stiffness_matrix(&self) -> SMatrix<f64, 1, 1> {
        SMatrix::<f64, 1, 1>::new(STIFFNESS)
    }

    fn damping_matrix(&self) -> SMatrix<f64, 1, 1> {
        SMatrix::<f64, 1, 1>::new(0.0)
    }
}
