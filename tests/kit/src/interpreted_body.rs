//! A body whose kernels are interpreted: any fidelity without compiling code.

use ffrf_codegen::formulate::Definition;
use ffrf_codegen::formulate::kernels::{
    DAMPING, FORWARD_DYNAMICS, MASS_MATRIX, MODAL_MASS, PREPARE, QUADRATIC_VELOCITY, STIFFNESS,
};
use ffrf_codegen::{KernelInput, Kernels};
use ffrf_runtime::nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use ffrf_runtime::{
    DenseForms, EquationsOfMotion, FlexibleBody, GeneralisedForce, ModalMatrix, Motion, Observables, Prepared,
};

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

    fn modal(&self, kernel: &Definition) -> ModalMatrix<SVector<f64, M>, f64> {
        ModalMatrix::Dense(self.square(kernel, &KernelInput::default()))
    }
}

fn state<'a, const M: usize>(
    q: &'a SVector<f64, M>,
    omega: &'a Vector3<f64>,
    q_dot: &'a SVector<f64, M>,
) -> KernelInput<'a> {
    KernelInput { q: q.as_slice(), omega: omega.as_slice(), q_dot: q_dot.as_slice(), ..Default::default() }
}

impl<const M: usize, const N: usize> FlexibleBody for InterpretedBody<M, N> {
    type Modal = SVector<f64, M>;

    fn undeformed(&self) -> SVector<f64, M> {
        SVector::zeros()
    }

    fn modal_mass(&self) -> ModalMatrix<SVector<f64, M>, f64> {
        self.modal(&MODAL_MASS)
    }

    fn stiffness(&self) -> ModalMatrix<SVector<f64, M>, f64> {
        self.modal(&STIFFNESS)
    }

    fn damping(&self) -> ModalMatrix<SVector<f64, M>, f64> {
        self.modal(&DAMPING)
    }

    fn prepare(
        &self,
        q: &SVector<f64, M>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
    ) -> Prepared<SVector<f64, M>> {
        let entries = self.0.evaluate(&PREPARE, &state(q, omega, q_dot));
        let mut rest = entries.as_slice();
        let mut take = |count: usize| {
            let (these, later) = rest.split_at(count);
            rest = later;
            these
        };
        Prepared {
            mass: take(1)[0],
            first_moment: Vector3::from_column_slice(take(3)),
            inertia: Matrix3::from_column_slice(take(9)),
            modal_first_moment: std::array::from_fn(|_| SVector::from_column_slice(take(M))),
            rotation_modal_coupling: std::array::from_fn(|_| SVector::from_column_slice(take(M))),
            quadratic_velocity: GeneralisedForce::from_vector(&SVector::<f64, N>::from_column_slice(take(N))),
            internal_force: SVector::from_column_slice(take(M)),
        }
    }

    fn forward_dynamics(
        &self,
        q: &SVector<f64, M>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
        force: &GeneralisedForce<SVector<f64, M>>,
    ) -> Motion<SVector<f64, M>> {
        let force = force.to_vector::<N>();
        let input = KernelInput { force: force.as_slice(), ..state(q, omega, q_dot) };
        Motion::from_vector(&self.vector::<N>(&FORWARD_DYNAMICS, &input))
    }

    fn internal_force(&self, q: &SVector<f64, M>, q_dot: &SVector<f64, M>) -> SVector<f64, M> {
        SVector::from_row_slice(&self.0.internal_force(q.as_slice(), q_dot.as_slice()))
    }

    fn gravity_force(
        &self,
        q: &SVector<f64, M>,
        gravity: &Vector3<f64>,
    ) -> GeneralisedForce<SVector<f64, M>> {
        let entries = self.0.gravity_force(q.as_slice(), gravity.as_slice());
        GeneralisedForce::from_vector(&SVector::<f64, N>::from_row_slice(&entries))
    }
}

impl<const M: usize, const N: usize> Observables for InterpretedBody<M, N> {
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
}

impl<const M: usize, const N: usize> DenseForms<M, N> for InterpretedBody<M, N> {
    fn mass_matrix(&self, q: &SVector<f64, M>) -> SMatrix<f64, N, N> {
        self.square(&MASS_MATRIX, &KernelInput { q: q.as_slice(), ..Default::default() })
    }

    fn quadratic_velocity(
        &self,
        q: &SVector<f64, M>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
    ) -> SVector<f64, N> {
        self.vector(&QUADRATIC_VELOCITY, &state(q, omega, q_dot))
    }

    fn equations_of_motion(
        &self,
        q: &SVector<f64, M>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
        force: &SVector<f64, N>,
    ) -> EquationsOfMotion<M, N> {
        let input = KernelInput { force: force.as_slice(), ..state(q, omega, q_dot) };
        EquationsOfMotion {
            mass_matrix: self.mass_matrix(q),
            quadratic_velocity: self.quadratic_velocity(q, omega, q_dot),
            acceleration: self.vector(&FORWARD_DYNAMICS, &input),
        }
    }
}
