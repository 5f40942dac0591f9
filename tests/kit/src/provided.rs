//! A body that has the required methods of another one and nothing else: the runtime does the rest.

use ffrf_runtime::nalgebra::{RealField, SVector, Vector3};
use ffrf_runtime::{DenseForms, FlexibleBody, ModalMatrix, Observables, Prepared};

/// The body in it, by the provided methods of the traits alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Provided<B>(pub B);

impl<B: FlexibleBody<T>, T: RealField + Copy> FlexibleBody<T> for Provided<B> {
    type Modal = B::Modal;

    fn undeformed(&self) -> B::Modal {
        self.0.undeformed()
    }

    fn modal_mass(&self) -> ModalMatrix<B::Modal, T> {
        self.0.modal_mass()
    }

    fn stiffness(&self) -> ModalMatrix<B::Modal, T> {
        self.0.stiffness()
    }

    fn damping(&self) -> ModalMatrix<B::Modal, T> {
        self.0.damping()
    }

    fn prepare(&self, q: &B::Modal, omega: &Vector3<T>, q_dot: &B::Modal) -> Prepared<B::Modal, T> {
        self.0.prepare(q, omega, q_dot)
    }
}

impl<B: FlexibleBody<T>, T: RealField + Copy> Observables<T> for Provided<B> {}

impl<B, const M: usize, const N: usize, T> DenseForms<M, N, T> for Provided<B>
where
    B: FlexibleBody<T, Modal = SVector<T, M>>,
    T: RealField + Copy,
{
}
