//! What can be observed of a body: energies, momenta, mass.

use nalgebra::{RealField, Vector3};

use super::{FlexibleBody, ModalVector, Motion};

/// Energies and momenta of a body, computed from [`FlexibleBody::prepare`] unless a body has something faster.
///
/// `velocity` is that of the frame origin, resolved in the body frame as everything else.
pub trait Observables<T: RealField + Copy = f64>: FlexibleBody<T> {
    /// Kinetic energy. Units: J.
    fn kinetic_energy(
        &self,
        q: &Self::Modal,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &Self::Modal,
    ) -> T {
        let motion = Motion { linear: *velocity, angular: *omega, modal: q_dot.clone() };
        let momentum = self.prepare(q, omega, q_dot).mass_times(&self.modal_mass(), &motion);
        momentum.power(&motion) * nalgebra::convert(0.5)
    }

    /// Elastic energy ½ qᵀ K q. Units: J.
    fn elastic_energy(&self, q: &Self::Modal) -> T {
        self.stiffness().product(q).dot(q) * nalgebra::convert(0.5)
    }

    /// Linear momentum. Shape: 3. Units: N s.
    fn linear_momentum(
        &self,
        q: &Self::Modal,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &Self::Modal,
    ) -> Vector3<T> {
        let motion = Motion { linear: *velocity, angular: *omega, modal: q_dot.clone() };
        self.prepare(q, omega, q_dot).mass_times(&self.modal_mass(), &motion).force
    }

    /// Angular momentum about the frame origin. Shape: 3. Units: N m s.
    fn angular_momentum(
        &self,
        q: &Self::Modal,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &Self::Modal,
    ) -> Vector3<T> {
        let motion = Motion { linear: *velocity, angular: *omega, modal: q_dot.clone() };
        self.prepare(q, omega, q_dot).mass_times(&self.modal_mass(), &motion).moment
    }

    /// Mass m. Units: kg.
    fn mass(&self) -> T {
        let rest = self.undeformed();
        self.prepare(&rest, &Vector3::zeros(), &rest).mass
    }

    /// First moment of mass m r(q) about the frame origin. Shape: 3. Units: kg m. Source: (204), r = a + q_μ b_μ.
    fn first_mass_moment(&self, q: &Self::Modal) -> Vector3<T> {
        self.prepare(q, &Vector3::zeros(), &self.undeformed()).first_moment
    }
}
