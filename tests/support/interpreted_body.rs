//! A body whose kernels are interpreted: any fidelity without compiling code.

use ffrf::nalgebra::{SMatrix, SVector, Vector3};
use ffrf::{EquationsOfMotion, FlexibleBody};
use ffrf_codegen::formulate::Definition;
use ffrf_codegen::formulate::kernels::{
    DAMPING_MATRIX, FORWARD_DYNAMICS, MASS_MATRIX, QUADRATIC_VELOCITY, STIFFNESS_MATRIX,
};
use ffrf_codegen::{KernelInput, Kernels};

/// The kernels of a model, as expressions.
#[derive(Debug, Clone)]
pub struct InterpretedBody<const M: usize, const N: usize>(pub Kernels);

impl<const M: usize, const N: usize> InterpretedBody<M, N> {
    fn vector<const R: usize>(&self, kernel: &Definition, input: &KernelInput<'_>) -> SVector<f64, R> {
        SVector::from_row_slice(&self.0.evaluate(kernel, input))
    }

    fn square<const R: usize>(&self, kernel: &Definition, input: &KernelInput<'_>) -> SMatrix<f64, R, R> {
        SMatrix::from_column_slice(&self.0.evaluate(kernel, input))
    }
}

impl<const M: usize, const N: usize> FlexibleBody<M, N> for InterpretedBody<M, N> {
    fn mass_matrix(&self, q: &SVector<f64, M>) -> SMatrix<f64, N, N> {
        self.square(&MASS_MATRIX, &KernelInput { q: q.as_slice(), ..Default::default() })
    }

    fn quadratic_velocity(
        &self,
        q: &SVector<f64, M>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
    ) -> SVector<f64, N> {
        let input = KernelInput {
            q: q.as_slice(),
            omega: omega.as_slice(),
            q_dot: q_dot.as_slice(),
            ..Default::default()
        };
        self.vector(&QUADRATIC_VELOCITY, &input)
    }

    fn forward_dynamics(
        &self,
        q: &SVector<f64, M>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
        force: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let input = KernelInput {
            q: q.as_slice(),
            omega: omega.as_slice(),
            q_dot: q_dot.as_slice(),
            force: force.as_slice(),
            ..Default::default()
        };
        self.vector(&FORWARD_DYNAMICS, &input)
    }

    fn equations_of_motion(
        &self,
        q: &SVector<f64, M>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
        force: &SVector<f64, N>,
    ) -> EquationsOfMotion<M, N> {
        EquationsOfMotion {
            mass_matrix: self.mass_matrix(q),
            quadratic_velocity: self.quadratic_velocity(q, omega, q_dot),
            acceleration: self.forward_dynamics(q, omega, q_dot, force),
        }
    }

    fn kinetic_energy(
        &self,
        q: &SVector<f64, M>,
        velocity: &Vector3<f64>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
    ) -> f64 {
        self.0.kinetic_energy(q.as_slice(), velocity.as_slice(), omega.as_slice(), q_dot.as_slice())
    }

    fn elastic_energy(&self, q: &SVector<f64, M>) -> f64 {
        self.0.elastic_energy(q.as_slice())
    }

    fn linear_momentum(
        &self,
        q: &SVector<f64, M>,
        velocity: &Vector3<f64>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
    ) -> Vector3<f64> {
        let momentum =
            self.0.linear_momentum(q.as_slice(), velocity.as_slice(), omega.as_slice(), q_dot.as_slice());
        Vector3::from_row_slice(&momentum)
    }

    fn angular_momentum(
        &self,
        q: &SVector<f64, M>,
        velocity: &Vector3<f64>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
    ) -> Vector3<f64> {
        let momentum =
            self.0.angular_momentum(q.as_slice(), velocity.as_slice(), omega.as_slice(), q_dot.as_slice());
        Vector3::from_row_slice(&momentum)
    }

    fn internal_force(&self, q: &SVector<f64, M>, q_dot: &SVector<f64, M>) -> SVector<f64, M> {
        SVector::from_row_slice(&self.0.internal_force(q.as_slice(), q_dot.as_slice()))
    }

    fn gravity_force(&self, q: &SVector<f64, M>, gravity: &Vector3<f64>) -> SVector<f64, N> {
        SVector::from_row_slice(&self.0.gravity_force(q.as_slice(), gravity.as_slice()))
    }

    fn stiffness_matrix(&self) -> SMatrix<f64, M, M> {
        self.square(&STIFFNESS_MATRIX, &KernelInput::default())
    }

    fn damping_matrix(&self) -> SMatrix<f64, M, M> {
        self.square(&DAMPING_MATRIX, &KernelInput::default())
    }
}
