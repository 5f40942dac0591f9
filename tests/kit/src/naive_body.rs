//! The equations written down as they stand, with nalgebra: the naive witness for every generated kernel.
//!
//! Nothing is unrolled, elided or shared; all invariants are dense; the accelerations come from a Cholesky
//! factorisation of the whole mass matrix. Use it to check generated bodies and as the plain column in
//! benchmarks. It holds no tricks on purpose: a doubt about a kernel is settled by reading this file.

use ffrf_model::GeometricStiffness;
use ffrf_runtime::nalgebra::{Cholesky, Matrix3, RealField, SMatrix, SVector, Vector3, convert};
use ffrf_runtime::{
    DenseForms, EquationsOfMotion, FlexibleBody, GeneralisedForce, ModalMatrix, Motion, Observables, Prepared,
};

/// The inertia invariants (206) with modal stiffness and damping, as plain arrays about the frame origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Invariants<const M: usize, T = f64> {
    /// Mass m. Units: kg.
    pub mass: T,
    /// Centre of mass a of the undeformed body. Shape: 3. Units: m. Frame: body.
    pub centre_of_mass: [T; 3],
    /// Its shift b_μ per unit modal coordinate. Shape: M x 3.
    pub modal_centre_of_mass: [[T; 3]; M],
    /// Euler tensor T, T^{ij} = ∫ρ xⁱ xʲ. Shape: 3 x 3, rows first. Units: kg m².
    pub euler_tensor: [[T; 3]; 3],
    /// T_μ, T_μ^{ij} = ∫ρ xⁱ φ_μʲ. Shape: M x 3 x 3, rows first.
    pub modal_euler_tensor: [[[T; 3]; 3]; M],
    /// T_μν, T_μν^{ij} = ∫ρ φ_μⁱ φ_νʲ. Shape: M x M x 3 x 3, rows first.
    pub modal_pair_euler_tensor: [[[[T; 3]; 3]; M]; M],
    /// Modal stiffness K_ff. Shape: M x M.
    pub stiffness: [[T; M]; M],
    /// Modal damping D_ff. Shape: M x M.
    pub damping: [[T; M]; M],
}

/// A flexible body that evaluates the equations of motion naively.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NaiveBody<const M: usize, const N: usize, T: RealField = f64> {
    mass: T,
    centre_of_mass: Vector3<T>,
    /// B = [b_μ].
    modal_centre_of_mass: SMatrix<T, 3, M>,
    /// Θ.
    inertia: Matrix3<T>,
    /// Θ_μ.
    modal_inertia: [Matrix3<T>; M],
    /// Θ_μν.
    modal_pair_inertia: [[Matrix3<T>; M]; M],
    /// ϑ_μ.
    coupling: [Vector3<T>; M],
    /// ϑ_μν.
    pair_coupling: [[Vector3<T>; M]; M],
    /// Θ_ff.
    modal_mass: SMatrix<T, M, M>,
    stiffness: SMatrix<T, M, M>,
    damping: SMatrix<T, M, M>,
    /// Geometric stiffness Γ_μν of uniform loads.
    uniform_load: [[Vector3<T>; M]; M],
    /// Geometric stiffness Γ_μν of linear loads.
    linear_load: [[Matrix3<T>; M]; M],
    is_stiffened: bool,
}

impl<const M: usize, const N: usize, T: RealField + Copy> NaiveBody<M, N, T> {
    /// Derives the inertia tensors (207), (208) of the corrected equations from the invariants.
    pub fn new(invariants: &Invariants<M, T>) -> Self {
        const { assert!(N == 6 + M, "a body with M modes has N = 6 + M velocities") };
        let modal = invariants.modal_euler_tensor.map(|tensor| matrix3(&tensor));
        let pairs = invariants.modal_pair_euler_tensor.map(|row| row.map(|tensor| matrix3(&tensor)));
        Self {
            mass: invariants.mass,
            centre_of_mass: Vector3::from(invariants.centre_of_mass),
            modal_centre_of_mass: SMatrix::from_fn(|i, mu| invariants.modal_centre_of_mass[mu][i]),
            inertia: inertia(&matrix3(&invariants.euler_tensor)),
            modal_inertia: modal.map(|tensor| inertia(&tensor)),
            modal_pair_inertia: pairs.map(|row| row.map(|tensor| inertia(&tensor))),
            coupling: modal.map(|tensor| axial(&tensor)),
            pair_coupling: pairs.map(|row| row.map(|tensor| axial(&tensor))),
            modal_mass: SMatrix::from_fn(|mu, nu| pairs[mu][nu].trace()),
            stiffness: SMatrix::from_fn(|mu, nu| invariants.stiffness[mu][nu]),
            damping: SMatrix::from_fn(|mu, nu| invariants.damping[mu][nu]),
            uniform_load: [[Vector3::zeros(); M]; M],
            linear_load: [[Matrix3::zeros(); M]; M],
            is_stiffened: false,
        }
    }

    /// The body with the geometric stiffness of a model, if that has any.
    pub fn stiffened(mut self, geometric: Option<&GeometricStiffness>) -> Self {
        if let Some(geometric) = geometric {
            self.is_stiffened = true;
            for mu in 0..M {
                for nu in 0..M {
                    self.uniform_load[mu][nu] = Vector3::from(geometric.uniform_load[mu][nu]).map(convert);
                    self.linear_load[mu][nu] = matrix3(&geometric.linear_load[mu][nu]).map(convert);
                }
            }
        }
        self
    }

    /// m r(q) = m a + m q_μ b_μ - ½ q_μ q_ν Γ_μν. Source: (204), sign corrected.
    fn first_moment(&self, q: &SVector<T, M>) -> Vector3<T> {
        let half: T = convert(0.5);
        let mut sum = (self.centre_of_mass + self.modal_centre_of_mass * q) * self.mass;
        if !self.is_stiffened {
            return sum;
        }
        for mu in 0..M {
            for nu in 0..M {
                sum -= self.uniform_load[mu][nu] * (half * q[mu] * q[nu]);
            }
        }
        sum
    }

    /// m B - [Γ_μν q_ν]_μ.
    fn modal_first_moment(&self, q: &SVector<T, M>) -> SMatrix<T, 3, M> {
        let mut moments = self.modal_centre_of_mass * self.mass;
        if !self.is_stiffened {
            return moments;
        }
        for mu in 0..M {
            let mut column = moments.column(mu).into_owned();
            for nu in 0..M {
                column -= self.uniform_load[mu][nu] * q[nu];
            }
            moments.set_column(mu, &column);
        }
        moments
    }

    /// Θ_rr(q) = Θ + q_μ (Θ_μ + Θ_μᵀ) + q_μ q_ν Θ_μν. Source: (204), symmetrised.
    fn deformed_inertia(&self, q: &SVector<T, M>) -> Matrix3<T> {
        let half: T = convert(0.5);
        let mut sum = self.inertia;
        for mu in 0..M {
            sum += (self.modal_inertia[mu] + self.modal_inertia[mu].transpose()) * q[mu];
            for nu in 0..M {
                sum += self.modal_pair_inertia[mu][nu] * (q[mu] * q[nu]);
                if self.is_stiffened {
                    // The pair (ν, μ) brings the same Γ: half of Γ and half of its transpose each.
                    let second = inertia(&self.linear_load[mu][nu]);
                    sum -= (second + second.transpose()) * (half * q[mu] * q[nu]);
                }
            }
        }
        sum
    }

    /// Θ_μ^d(q) = Θ_μ + q_ν Θ_νμ. Source: (205), index order corrected.
    fn deformed_modal_inertia(&self, mu: usize, q: &SVector<T, M>) -> Matrix3<T> {
        let mut sum = self.modal_inertia[mu];
        for nu in 0..M {
            sum += self.modal_pair_inertia[nu][mu] * q[nu];
            if self.is_stiffened {
                sum -= inertia(&self.linear_load[nu][mu]) * q[nu];
            }
        }
        sum
    }

    /// Θ_rf(q) = [ϑ_μ + q_ν ϑ_νμ]_μ. Source: (204).
    fn rotation_modal_coupling(&self, q: &SVector<T, M>) -> SMatrix<T, 3, M> {
        let mut coupling = SMatrix::<T, 3, M>::zeros();
        for mu in 0..M {
            let mut column = self.coupling[mu];
            for nu in 0..M {
                column += self.pair_coupling[nu][mu] * q[nu];
                if self.is_stiffened {
                    column -= axial(&self.linear_load[nu][mu]) * q[nu];
                }
            }
            coupling.set_column(mu, &column);
        }
        coupling
    }
}

/// All of it from the dense forms below: the accelerations do not take the way over [`Prepared`].
impl<const M: usize, const N: usize, T: RealField + Copy> FlexibleBody<T> for NaiveBody<M, N, T> {
    type Modal = SVector<T, M>;

    fn undeformed(&self) -> SVector<T, M> {
        SVector::zeros()
    }

    fn is_stiffened(&self) -> bool {
        self.is_stiffened
    }

    fn modal_mass(&self) -> ModalMatrix<SVector<T, M>, T> {
        ModalMatrix::Dense(self.modal_mass)
    }

    fn stiffness(&self) -> ModalMatrix<SVector<T, M>, T> {
        ModalMatrix::Dense(self.stiffness)
    }

    fn damping(&self) -> ModalMatrix<SVector<T, M>, T> {
        ModalMatrix::Dense(self.damping)
    }

    fn prepare(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> Prepared<SVector<T, M>, T> {
        Prepared {
            mass: self.mass,
            first_moment: self.first_moment(q),
            inertia: self.deformed_inertia(q),
            modal_first_moment: rows(&self.modal_first_moment(q)),
            rotation_modal_coupling: rows(&self.rotation_modal_coupling(q)),
            quadratic_velocity: GeneralisedForce::from_vector(&self.quadratic_velocity(q, omega, q_dot)),
            internal_force: self.internal_force(q, q_dot),
        }
    }

    fn forward_dynamics(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        force: &GeneralisedForce<SVector<T, M>, T>,
    ) -> Motion<SVector<T, M>, T> {
        Motion::from_vector(&self.equations_of_motion(q, omega, q_dot, &force.to_vector()).acceleration)
    }

    fn internal_force(&self, q: &SVector<T, M>, q_dot: &SVector<T, M>) -> SVector<T, M> {
        self.stiffness * q + self.damping * q_dot
    }

    fn gravity_force(&self, q: &SVector<T, M>, gravity: &Vector3<T>) -> GeneralisedForce<SVector<T, M>, T> {
        GeneralisedForce {
            force: gravity * self.mass,
            moment: self.first_moment(q).cross(gravity),
            modal: self.modal_first_moment(q).tr_mul(gravity),
        }
    }
}

impl<const M: usize, const N: usize, T: RealField + Copy> DenseForms<M, N, T> for NaiveBody<M, N, T> {
    fn mass_matrix(&self, q: &SVector<T, M>) -> SMatrix<T, N, N> {
        let translation_rotation = -self.first_moment(q).cross_matrix();
        let translation_modal = self.modal_first_moment(q);
        let rotation_modal = self.rotation_modal_coupling(q);
        let mut mass = SMatrix::<T, N, N>::zeros();
        mass.fixed_view_mut::<3, 3>(0, 0).copy_from(&(Matrix3::identity() * self.mass));
        mass.fixed_view_mut::<3, 3>(0, 3).copy_from(&translation_rotation);
        mass.fixed_view_mut::<3, 3>(3, 0).copy_from(&translation_rotation.transpose());
        mass.fixed_view_mut::<3, M>(0, 6).copy_from(&translation_modal);
        mass.fixed_view_mut::<M, 3>(6, 0).copy_from(&translation_modal.transpose());
        mass.fixed_view_mut::<3, 3>(3, 3).copy_from(&self.deformed_inertia(q));
        mass.fixed_view_mut::<3, M>(3, 6).copy_from(&rotation_modal);
        mass.fixed_view_mut::<M, 3>(6, 3).copy_from(&rotation_modal.transpose());
        mass.fixed_view_mut::<M, M>(6, 6).copy_from(&self.modal_mass);
        mass
    }

    fn quadratic_velocity(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> SVector<T, N> {
        let two: T = convert(2.0);
        // Q_t = m ω × (ω × r) + 2 m ω × (B q̇)
        let centripetal = omega.cross(&omega.cross(&self.first_moment(q)));
        let coriolis = omega.cross(&(self.modal_first_moment(q) * q_dot)) * two;
        // Q_r = ω × (Θ_rr ω) + 2 q̇_μ Θ_μ^d ω
        let mut rotational = omega.cross(&(self.deformed_inertia(q) * omega));
        for mu in 0..M {
            rotational += self.deformed_modal_inertia(mu, q) * omega * (two * q_dot[mu]);
        }
        // and what steady rates leave of second order: -Γ_μν q̇_μ q̇_ν
        let mut translational = centripetal + coriolis;
        let loads = if self.is_stiffened { M } else { 0 };
        for mu in 0..loads {
            for nu in 0..loads {
                translational -= self.uniform_load[mu][nu] * (q_dot[mu] * q_dot[nu]);
                rotational -= axial(&self.linear_load[mu][nu]) * (q_dot[mu] * q_dot[nu]);
            }
        }
        let mut result = SVector::<T, N>::zeros();
        result.fixed_rows_mut::<3>(0).copy_from(&translational);
        result.fixed_rows_mut::<3>(3).copy_from(&rotational);
        // Q_f,μ = -ω · Θ_μ^d ω + 2 q̇_ν ω · ϑ_νμ
        for mu in 0..M {
            let mut modal = -omega.dot(&(self.deformed_modal_inertia(mu, q) * omega));
            for nu in 0..M {
                modal += omega.dot(&self.pair_coupling[nu][mu]) * (two * q_dot[nu]);
            }
            result[6 + mu] = modal;
        }
        result
    }

    fn equations_of_motion(
        &self,
        q: &SVector<T, M>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
        force: &SVector<T, N>,
    ) -> EquationsOfMotion<M, N, T> {
        let mass_matrix = self.mass_matrix(q);
        let quadratic_velocity = self.quadratic_velocity(q, omega, q_dot);
        let mut right = force - quadratic_velocity;
        let internal = self.internal_force(q, q_dot);
        for mu in 0..M {
            right[6 + mu] -= internal[mu];
        }
        let not_a_number: T = convert(f64::NAN);
        let acceleration = match Cholesky::new(mass_matrix) {
            Some(factors) => factors.solve(&right),
            None => SVector::repeat(not_a_number),
        };
        EquationsOfMotion { mass_matrix, quadratic_velocity, acceleration }
    }
}

impl<const M: usize, const N: usize, T: RealField + Copy> Observables<T> for NaiveBody<M, N, T> {
    fn kinetic_energy(
        &self,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> T {
        let half: T = convert(0.5);
        velocity.dot(velocity) * half * self.mass
            + velocity.dot(&omega.cross(&self.first_moment(q)))
            + velocity.dot(&(self.modal_first_moment(q) * q_dot))
            + omega.dot(&(self.deformed_inertia(q) * omega)) * half
            + omega.dot(&(self.rotation_modal_coupling(q) * q_dot))
            + q_dot.dot(&(self.modal_mass * q_dot)) * half
    }

    fn elastic_energy(&self, q: &SVector<T, M>) -> T {
        let half: T = convert(0.5);
        q.dot(&(self.stiffness * q)) * half
    }

    fn linear_momentum(
        &self,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> Vector3<T> {
        velocity * self.mass + omega.cross(&self.first_moment(q)) + self.modal_first_moment(q) * q_dot
    }

    fn angular_momentum(
        &self,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> Vector3<T> {
        self.first_moment(q).cross(velocity)
            + self.deformed_inertia(q) * omega
            + self.rotation_modal_coupling(q) * q_dot
    }

    fn mass(&self) -> T {
        self.mass
    }

    fn first_mass_moment(&self, q: &SVector<T, M>) -> Vector3<T> {
        self.first_moment(q)
    }
}

/// The rows of `matrix`.
fn rows<const M: usize, T: RealField + Copy>(matrix: &SMatrix<T, 3, M>) -> [SVector<T, M>; 3] {
    [0, 1, 2].map(|row| matrix.row(row).transpose())
}

/// The matrix with these rows.
fn matrix3<T: RealField + Copy>(rows: &[[T; 3]; 3]) -> Matrix3<T> {
    Matrix3::from_fn(|i, j| rows[i][j])
}

/// tr(T) I - Tᵀ. Source: (207), transpose corrected.
fn inertia<T: RealField + Copy>(tensor: &Matrix3<T>) -> Matrix3<T> {
    Matrix3::identity() * tensor.trace() - tensor.transpose()
}

/// ε_ijk T^{ij} e_k. Source: (208), in the form that needs no convention for Θ.
fn axial<T: RealField + Copy>(tensor: &Matrix3<T>) -> Vector3<T> {
    Vector3::new(
        tensor[(1, 2)] - tensor[(2, 1)],
        tensor[(2, 0)] - tensor[(0, 2)],
        tensor[(0, 1)] - tensor[(1, 0)],
    )
}
