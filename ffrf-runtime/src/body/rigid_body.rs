//! A rigid body: a flexible one without modes, with numbers that come at run time.

use nalgebra::{Matrix3, RealField, SVector, Vector3};

use super::{FlexibleBody, GeneralisedForce, ModalMatrix, Observables, Prepared};

/// A rigid body; its frame may lie anywhere in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidBody<T = f64> {
    mass: T,
    first_moment: Vector3<T>,
    /// About the frame origin.
    inertia: Matrix3<T>,
}

impl<T: RealField + Copy> RigidBody<T> {
    /// From mass (kg), centre of mass (m, body frame) and inertia tensor about the *centre of mass* (kg m², body frame).
    pub fn new(mass: T, center_of_mass: Vector3<T>, inertia: Matrix3<T>) -> Self {
        // Steiner: -m c~ c~
        let c = center_of_mass;
        let shift = (Matrix3::from_diagonal_element(c.norm_squared()) - c * c.transpose()) * mass;
        Self { mass, first_moment: c * mass, inertia: inertia + shift }
    }
}

impl<T: RealField + Copy> FlexibleBody<T> for RigidBody<T> {
    type Modal = SVector<T, 0>;

    fn undeformed(&self) -> Self::Modal {
        SVector::zeros()
    }

    fn modal_mass(&self) -> ModalMatrix<Self::Modal, T> {
        ModalMatrix::Diagonal(SVector::zeros())
    }

    fn stiffness(&self) -> ModalMatrix<Self::Modal, T> {
        ModalMatrix::Diagonal(SVector::zeros())
    }

    fn damping(&self) -> ModalMatrix<Self::Modal, T> {
        ModalMatrix::Diagonal(SVector::zeros())
    }

    fn prepare(&self, q: &Self::Modal, omega: &Vector3<T>, _: &Self::Modal) -> Prepared<Self::Modal, T> {
        Prepared {
            mass: self.mass,
            first_moment: self.first_moment,
            inertia: self.inertia,
            modal_first_moment: [*q; 3],
            rotation_modal_coupling: [*q; 3],
            quadratic_velocity: GeneralisedForce {
                force: omega.cross(&omega.cross(&self.first_moment)),
                moment: omega.cross(&(self.inertia * omega)),
                modal: *q,
            },
            internal_force: *q,
        }
    }
}

impl<T: RealField + Copy> Observables<T> for RigidBody<T> {}
