//! What a flexible body is: constants and one function of its state.

use nalgebra::{RealField, Vector3};

use super::{GeneralisedForce, Marker, ModalMatrix, ModalVector, Motion, Prepared};

/// A flexible body in the scalar type `T`; the number of its modes is that of [`Modal`](Self::Modal).
///
/// Five methods make a body. Unknowns are the accelerations α = Aᵀp̈ of the frame origin, ω̇ and q̈, with
/// `M(q) [α; ω̇; q̈] + Q(q, ω, q̇) + [0; 0; K q + D q̇] = force`; every vector is resolved in the body frame.
/// No method allocates or panics. Generated bodies override the provided methods with faster kernels.
pub trait FlexibleBody<T: RealField + Copy = f64> {
    /// A vector over the modes: `SVector<T, M>` on the target.
    type Modal: ModalVector<T>;

    /// Modal coordinates of the undeformed body: zeros. Shape: M.
    fn undeformed(&self) -> Self::Modal;
    /// Modal mass Θ_ff. Shape: M x M.
    fn modal_mass(&self) -> ModalMatrix<Self::Modal, T>;
    /// Modal stiffness K_ff. Shape: M x M.
    fn stiffness(&self) -> ModalMatrix<Self::Modal, T>;
    /// Modal damping D_ff. Shape: M x M.
    fn damping(&self) -> ModalMatrix<Self::Modal, T>;
    /// Everything that depends on the state, in one pass. Source: (204), (209), corrected.
    fn prepare(&self, q: &Self::Modal, omega: &Vector3<T>, q_dot: &Self::Modal) -> Prepared<Self::Modal, T>;

    /// Accelerations under `force`, elastic and damping forces included.
    ///
    /// q̈ is eliminated first; the dense mass matrix is never formed. Not a number where no body can be: with a mass
    /// matrix that is not positive definite.
    fn forward_dynamics(
        &self,
        q: &Self::Modal,
        omega: &Vector3<T>,
        q_dot: &Self::Modal,
        force: &GeneralisedForce<Self::Modal, T>,
    ) -> Motion<Self::Modal, T> {
        let prepared = self.prepare(q, omega, q_dot);
        let factors = self.modal_mass().factor().and_then(|modal| prepared.eliminate(modal).factor());
        match factors {
            Some(factors) => factors.solve(&prepared.net_force(force)),
            None => {
                let mut nowhere = Motion::zeros(q);
                nowhere.scale(T::zero() / T::zero());
                nowhere
            }
        }
    }

    /// Elastic and damping forces K q + D q̇, on the left-hand side. Shape: M.
    fn internal_force(&self, q: &Self::Modal, q_dot: &Self::Modal) -> Self::Modal {
        let mut force = self.stiffness().product(q);
        force.add_scaled(T::one(), &self.damping().product(q_dot));
        force
    }

    /// Generalised force of uniform gravity. `gravity`: m/s², resolved in the body frame.
    fn gravity_force(&self, q: &Self::Modal, gravity: &Vector3<T>) -> GeneralisedForce<Self::Modal, T> {
        self.prepare(q, &Vector3::zeros(), &self.undeformed()).gravity_force(gravity)
    }

    /// Whether the stress of accelerations changes the stiffness: m B then follows the deformation, and Θ_rf in a way that the
    /// quadratic velocity vector does not show. Asked by the energy-momentum method.
    fn is_stiffened(&self) -> bool {
        false
    }

    /// The rows of a marker in the state `q`, if they follow the deformation: where loads at the marker stress the body, it moves by
    /// terms of second order in q, and its rows are φ_μ - Γ_μν q_ν. `None` for a marker whose rows are constant.
    ///
    /// The position is not changed: the place in the state `q` is the mean of those that both markers give.
    fn bent_marker(
        &self,
        marker: &Marker<Self::Modal, T>,
        q: &Self::Modal,
    ) -> Option<Marker<Self::Modal, T>> {
        let _ = (marker, q);
        None
    }

    /// The largest step of the classical Runge-Kutta method that keeps the body's vibration bounded. Units: s.
    ///
    /// From the highest frequency of the free body; `None` if it is not known, or if nothing vibrates.
    fn largest_stable_step(&self) -> Option<T> {
        None
    }
}

/// A reference to a body is that body.
impl<B: FlexibleBody<T>, T: RealField + Copy> FlexibleBody<T> for &B {
    type Modal = B::Modal;

    fn undeformed(&self) -> Self::Modal {
        (**self).undeformed()
    }

    fn modal_mass(&self) -> ModalMatrix<Self::Modal, T> {
        (**self).modal_mass()
    }

    fn stiffness(&self) -> ModalMatrix<Self::Modal, T> {
        (**self).stiffness()
    }

    fn damping(&self) -> ModalMatrix<Self::Modal, T> {
        (**self).damping()
    }

    fn prepare(&self, q: &Self::Modal, omega: &Vector3<T>, q_dot: &Self::Modal) -> Prepared<Self::Modal, T> {
        (**self).prepare(q, omega, q_dot)
    }

    fn forward_dynamics(
        &self,
        q: &Self::Modal,
        omega: &Vector3<T>,
        q_dot: &Self::Modal,
        force: &GeneralisedForce<Self::Modal, T>,
    ) -> Motion<Self::Modal, T> {
        (**self).forward_dynamics(q, omega, q_dot, force)
    }

    fn internal_force(&self, q: &Self::Modal, q_dot: &Self::Modal) -> Self::Modal {
        (**self).internal_force(q, q_dot)
    }

    fn gravity_force(&self, q: &Self::Modal, gravity: &Vector3<T>) -> GeneralisedForce<Self::Modal, T> {
        (**self).gravity_force(q, gravity)
    }

    fn is_stiffened(&self) -> bool {
        (**self).is_stiffened()
    }

    fn bent_marker(
        &self,
        marker: &Marker<Self::Modal, T>,
        q: &Self::Modal,
    ) -> Option<Marker<Self::Modal, T>> {
        (**self).bent_marker(marker, q)
    }

    fn largest_stable_step(&self) -> Option<T> {
        (**self).largest_stable_step()
    }
}
