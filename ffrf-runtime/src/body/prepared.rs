//! What depends on the state of a body, computed once for everything that needs it.

use nalgebra::{Cholesky, Const, Matrix3, Matrix6, RealField, Vector3, Vector6};

use super::modal_vector::scatter;
use super::{GeneralisedForce, ModalFactors, ModalMatrix, ModalVector, Motion};
use crate::six::{dot, subtract_scaled};

/// The deformed quantities of one state (q, ω, q̇) of a body. Frame: body.
///
/// With the modal mass Θ_ff they are the whole equations of motion,
///
/// ```text
/// [ m I     -m r~    m B  ]
/// [ m r~     Θ_rr    Θ_rf ] [α; ω̇; q̈] + Q + [0; 0; K q + D q̇] = force
/// [ (m B)ᵀ   Θ_rfᵀ   Θ_ff ]
/// ```
///
/// so forces, constraints and outputs of a time step share one of these.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prepared<V, T = f64> {
    /// Mass m. Units: kg.
    pub mass: T,
    /// First moment of mass m r(q). Shape: 3. Units: kg m. Source: (204).
    pub first_moment: Vector3<T>,
    /// Inertia tensor Θ_rr(q) about the frame origin. Shape: 3 x 3, symmetric. Units: kg m². Source: (204), symmetrised.
    pub inertia: Matrix3<T>,
    /// Rows of m B. Shape: 3 x M. Units: kg m per unit modal coordinate.
    pub modal_first_moment: [V; 3],
    /// Rows of Θ_rf(q). Shape: 3 x M. Units: kg m² per unit modal coordinate. Source: (204).
    pub rotation_modal_coupling: [V; 3],
    /// Quadratic velocity vector Q(q, ω, q̇), on the left-hand side. Source: (209), corrected.
    pub quadratic_velocity: GeneralisedForce<V, T>,
    /// Elastic and damping forces K q + D q̇, on the left-hand side. Shape: M.
    pub internal_force: V,
}

impl<V: ModalVector<T>, T: RealField + Copy> Prepared<V, T> {
    /// The rows of C = [m B; Θ_rf(q)], the coupling of rigid motion with the modes. Shape: 6 x M.
    pub fn coupling(&self) -> [&V; 6] {
        let [b_x, b_y, b_z] = &self.modal_first_moment;
        let [r_x, r_y, r_z] = &self.rotation_modal_coupling;
        [b_x, b_y, b_z, r_x, r_y, r_z]
    }

    /// Cᵀ, mode by mode. Shape: M x 6.
    pub(crate) fn coupling_sixes(&self) -> V::Sixes {
        let mut sixes = self.internal_force.zero_sixes();
        for (axis, row) in self.coupling().into_iter().enumerate() {
            scatter(row.as_slice(), axis, sixes.as_mut());
        }
        sixes
    }

    /// The block of rigid motion in the mass matrix. Shape: 6 x 6, symmetric.
    pub fn rigid_mass(&self) -> Matrix6<T> {
        let [x, y, z] = self.first_moment.into();
        let (m, o, i) = (self.mass, T::zero(), &self.inertia);
        // m r~ below, its transpose above the diagonal
        Matrix6::from_columns(&[
            Vector6::new(m, o, o, o, z, -y),
            Vector6::new(o, m, o, -z, o, x),
            Vector6::new(o, o, m, y, -x, o),
            Vector6::new(o, -z, y, i.m11, i.m21, i.m31),
            Vector6::new(z, o, -x, i.m12, i.m22, i.m32),
            Vector6::new(-y, x, o, i.m13, i.m23, i.m33),
        ])
    }

    /// What is left of `force` to accelerate the body: force - Q - [0; 0; K q + D q̇].
    pub fn net_force(&self, force: &GeneralisedForce<V, T>) -> GeneralisedForce<V, T> {
        let minus = -T::one();
        let mut net = force.clone();
        net.add_scaled(minus, &self.quadratic_velocity);
        net.modal.add_scaled(minus, &self.internal_force);
        net
    }

    /// The generalised force M(q) `motion`, the momentum if these are velocities.
    pub fn mass_times(
        &self,
        modal_mass: &ModalMatrix<V, T>,
        motion: &Motion<V, T>,
    ) -> GeneralisedForce<V, T> {
        let rows = |rows: &[V; 3]| {
            Vector3::new(rows[0].dot(&motion.modal), rows[1].dot(&motion.modal), rows[2].dot(&motion.modal))
        };
        let mut modal = modal_mass.product(&motion.modal);
        for axis in 0..3 {
            modal.add_scaled(motion.linear[axis], &self.modal_first_moment[axis]);
            modal.add_scaled(motion.angular[axis], &self.rotation_modal_coupling[axis]);
        }
        GeneralisedForce {
            force: motion.linear * self.mass
                + motion.angular.cross(&self.first_moment)
                + rows(&self.modal_first_moment),
            moment: self.first_moment.cross(&motion.linear)
                + self.inertia * motion.angular
                + rows(&self.rotation_modal_coupling),
            modal,
        }
    }

    /// The generalised force of uniform gravity: [m g; m r × g; (m B)ᵀ g].
    ///
    /// `gravity`: m/s², resolved in the body frame.
    pub fn gravity_force(&self, gravity: &Vector3<T>) -> GeneralisedForce<V, T> {
        let mut modal = self.internal_force.zeros_alike();
        for axis in 0..3 {
            modal.add_scaled(gravity[axis], &self.modal_first_moment[axis]);
        }
        GeneralisedForce { force: gravity * self.mass, moment: self.first_moment.cross(gravity), modal }
    }

    /// The mass matrix with the modes eliminated through the factors of Θ_ff, or of Θ_ff with implicit terms.
    #[inline]
    pub fn eliminate(&self, modal: ModalFactors<V, T>) -> Eliminated<V, T> {
        let coupling = self.coupling();
        let mut followed = self.coupling_sixes();
        modal.solve_sixes(&mut followed);
        let mut remaining = self.rigid_mass();
        for (place, row) in remaining.data.0.iter_mut().zip(coupling) {
            let mut column = *place;
            for (entry, followed) in row.as_slice().iter().zip(followed.as_ref()) {
                subtract_scaled(&mut column, *entry, followed);
            }
            *place = column;
        }
        Eliminated { followed, remaining, modal }
    }
}

/// The mass matrix with the modes eliminated: what forces and joints on the frame of a body meet.
///
/// Z = M_rr - C Θ_ff⁻¹ Cᵀ is what is left for rigid motion, with C = [m B; Θ_rf(q)].
#[derive(Debug, Clone)]
pub struct Eliminated<V: ModalVector<T>, T: RealField + Copy> {
    /// Θ_ff⁻¹ Cᵀ: how the modes follow rigid motion. Shape: M x 6.
    pub followed: V::Sixes,
    /// Z, symmetric to round-off. Shape: 6 x 6.
    pub remaining: Matrix6<T>,
    /// Factors of Θ_ff, with implicit terms if there are any.
    pub modal: ModalFactors<V, T>,
}

impl<V, T> Copy for Eliminated<V, T>
where
    V: ModalVector<T> + Copy,
    V::Sixes: Copy,
    V::Factors: Copy,
    T: RealField + Copy,
{
}

impl<V: ModalVector<T>, T: RealField + Copy> Eliminated<V, T> {
    /// The factors of the whole mass matrix, or `None` if it is not positive definite.
    pub fn factor(self) -> Option<Factored<V, T>> {
        let rigid = Cholesky::new(self.remaining)?;
        Some(Factored { eliminated: self, rigid })
    }

    /// The solution of M(q) w = `right`, or `None` if M is not positive definite: for a single right-hand side.
    pub(crate) fn solve(&self, right: &GeneralisedForce<V, T>) -> Option<Motion<V, T>> {
        let mut rigid = self.reduced_force(right);
        Cholesky::new(self.remaining)?.solve_mut(&mut rigid);
        Some(self.with_modes(&rigid, self.modal.solve(&right.modal)))
    }

    /// The force on the frame when the modes move freely under their part of `force`. Shape: 6.
    pub fn reduced_force(&self, force: &GeneralisedForce<V, T>) -> Vector6<T> {
        let [x, y, z] = force.force.into();
        let [r_x, r_y, r_z] = force.moment.into();
        let mut rigid = [x, y, z, r_x, r_y, r_z];
        for (force, followed) in force.modal.as_slice().iter().zip(self.followed.as_ref()) {
            subtract_scaled(&mut rigid, *force, followed);
        }
        rigid.into()
    }

    /// The whole motion from that of the frame and the modes' own part.
    pub fn with_modes(&self, rigid: &Vector6<T>, mut alone: V) -> Motion<V, T> {
        for (entry, followed) in alone.as_mut_slice().iter_mut().zip(self.followed.as_ref()) {
            *entry -= dot(followed, &rigid.data.0[0]);
        }
        Motion {
            linear: Vector3::new(rigid.x, rigid.y, rigid.z),
            angular: Vector3::new(rigid.w, rigid.a, rigid.b),
            modal: alone,
        }
    }
}

/// One factorisation of a body for many right-hand sides: Cholesky that begins with the modes, backward stable.
#[derive(Debug, Clone)]
pub struct Factored<V: ModalVector<T>, T: RealField + Copy> {
    /// The mass matrix without its modes.
    pub eliminated: Eliminated<V, T>,
    /// Factors of Z. Shape: 6 x 6.
    pub rigid: Cholesky<T, Const<6>>,
}

impl<V: ModalVector<T>, T: RealField + Copy> Factored<V, T> {
    /// The solution of M(q) w = `right`; with implicit terms if the modes were eliminated with them.
    pub fn solve(&self, right: &GeneralisedForce<V, T>) -> Motion<V, T> {
        let mut rigid = self.eliminated.reduced_force(right);
        self.rigid.solve_mut(&mut rigid);
        self.eliminated.with_modes(&rigid, self.eliminated.modal.solve(&right.modal))
    }
}
