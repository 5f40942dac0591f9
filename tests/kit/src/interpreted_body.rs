//! A body whose kernels are interpreted: any fidelity without compiling code.

use ffrf_codegen::Kernels;
use ffrf_runtime::nalgebra::{SMatrix, SVector, Vector3};
use ffrf_runtime::{DenseForms, FlexibleBody, GeneralisedForce, ModalMatrix, Motion, Observables, Prepared};

/// The kernels of a model, as expressions.
#[derive(Debug, Clone)]
pub struct InterpretedBody<const M: usize, const N: usize>(pub Kernels);

impl<const M: usize, const N: usize> InterpretedBody<M, N> {
    /// The matrix of a linear function, column by column.
    fn linear(function: impl Fn(&SVector<f64, M>) -> SVector<f64, M>) -> ModalMatrix<SVector<f64, M>, f64> {
        let mut matrix = SMatrix::<f64, M, M>::zeros();
        for mu in 0..M {
            let mut unit = SVector::<f64, M>::zeros();
            unit[mu] = 1.0;
            matrix.set_column(mu, &function(&unit));
        }
        ModalMatrix::Dense(matrix)
    }
}

/// All blocks come from the dense mass matrix: it is what a fidelity is stated for.
impl<const M: usize, const N: usize> FlexibleBody for InterpretedBody<M, N> {
    type Modal = SVector<f64, M>;

    fn undeformed(&self) -> SVector<f64, M> {
        SVector::zeros()
    }

    fn modal_mass(&self) -> ModalMatrix<SVector<f64, M>, f64> {
        let mass: SMatrix<f64, N, N> = self.mass_matrix(&SVector::zeros());
        ModalMatrix::Dense(mass.fixed_view::<M, M>(6, 6).into_owned())
    }

    fn stiffness(&self) -> ModalMatrix<SVector<f64, M>, f64> {
        Self::linear(|unit| self.internal_force(unit, &SVector::zeros()))
    }

    fn damping(&self) -> ModalMatrix<SVector<f64, M>, f64> {
        Self::linear(|unit| self.internal_force(&SVector::zeros(), unit))
    }

    fn prepare(
        &self,
        q: &SVector<f64, M>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
    ) -> Prepared<SVector<f64, M>> {
        let mass: SMatrix<f64, N, N> = self.mass_matrix(q);
        let rows = |start: usize| [0, 1, 2].map(|i| mass.fixed_view::<1, M>(start + i, 6).transpose());
        Prepared {
            mass: mass[(0, 0)],
            // -m r~ right of the mass
            first_moment: Vector3::new(mass[(1, 5)], mass[(2, 3)], mass[(0, 4)]),
            inertia: mass.fixed_view::<3, 3>(3, 3).into_owned(),
            modal_first_moment: rows(0),
            rotation_modal_coupling: rows(3),
            quadratic_velocity: GeneralisedForce::from_vector(&self.quadratic_velocity(q, omega, q_dot)),
            internal_force: self.internal_force(q, q_dot),
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
        let all = self.0.forward_dynamics(q.as_slice(), omega.as_slice(), q_dot.as_slice(), force.as_slice());
        Motion::from_vector(&SVector::<f64, N>::from_row_slice(&all))
    }

    fn internal_force(&self, q: &SVector<f64, M>, q_dot: &SVector<f64, M>) -> SVector<f64, M> {
        SVector::from_row_slice(&self.0.internal_force(q.as_slice(), q_dot.as_slice()))
    }

    fn gravity_force(
        &self,
        q: &SVector<f64, M>,
        gravity: &Vector3<f64>,
    ) -> GeneralisedForce<SVector<f64, M>> {
        let all = self.0.gravity_force(q.as_slice(), gravity.as_slice());
        GeneralisedForce::from_vector(&SVector::<f64, N>::from_row_slice(&all))
    }
}

impl<const M: usize, const N: usize> DenseForms<M, N> for InterpretedBody<M, N> {
    fn mass_matrix(&self, q: &SVector<f64, M>) -> SMatrix<f64, N, N> {
        SMatrix::from_column_slice(&self.0.mass_matrix(q.as_slice()).concat())
    }

    fn quadratic_velocity(
        &self,
        q: &SVector<f64, M>,
        omega: &Vector3<f64>,
        q_dot: &SVector<f64, M>,
    ) -> SVector<f64, N> {
        let all = self.0.quadratic_velocity(q.as_slice(), omega.as_slice(), q_dot.as_slice());
        SVector::from_row_slice(&all)
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
