//! The modes of a body as unknowns of their own, instead of eliminated inside it.
//!
//! Eliminated modes couple all joints on their body. For a hub with many arms that is dense, and costs the square of their
//! number to fill and its cube to factor. Kept modes are nodes in the elimination, coupled to the frame through
//! C = [m B; Θ_rf(q)] and to each joint through the gradients of its rows to the modes: arms stay apart.

use nalgebra::{Matrix6, RealField};

use crate::body::{ModalMatrix, ModalVector, Prepared};
use crate::six::Square;

/// What a body that keeps its modes has in the matrix. Frame: body.
#[derive(Debug, Clone, PartialEq)]
pub struct KeptModes<V: ModalVector<T>, T: RealField + Copy = f64> {
    /// The block of rigid motion. Shape: 6 x 6, symmetric.
    rigid: Matrix6<T>,
    /// Cᵀ. Shape: M x 6.
    coupling: V::Sixes,
    /// Θ_ff, with implicit terms if there are any. Shape: M x M.
    modal: ModalMatrix<V, T>,
}

impl<V, T> Copy for KeptModes<V, T>
where
    V: ModalVector<T> + Copy,
    V::Sixes: Copy,
    V::Matrix: Copy,
    T: RealField + Copy,
{
}

impl<V: ModalVector<T>, T: RealField + Copy> KeptModes<V, T> {
    /// Room for as many modes as there are zeros.
    pub fn empty(zeros: &V) -> Self {
        Self {
            rigid: Matrix6::zeros(),
            coupling: zeros.zero_sixes(),
            modal: ModalMatrix::Diagonal(zeros.clone()),
        }
    }

    pub(super) fn keep(&mut self, prepared: &Prepared<V, T>, modal: ModalMatrix<V, T>) {
        self.rigid = prepared.rigid_mass();
        self.coupling = prepared.coupling_sixes();
        self.modal = modal;
    }

    pub(super) fn rigid_mass(&self) -> Square<T> {
        self.rigid.data.0
    }

    /// Sets the rows of Cᵀ of the modes from `first` on.
    pub(super) fn coupling(&self, first: usize, to: &mut Square<T>) {
        copy_from(self.coupling.as_ref(), first, to);
    }

    /// Sets the entries of six modes with six; a mode that is not there has mass and moves nothing.
    pub(super) fn modal_mass(&self, rows: usize, columns: usize, to: &mut Square<T>) {
        for (i, row) in to.iter_mut().enumerate() {
            for (j, place) in row.iter_mut().enumerate() {
                let (mode, other) = (rows + i, columns + j);
                let missing = if mode == other { T::one() } else { T::zero() };
                *place = self.modal.entry(mode, other).unwrap_or(missing);
            }
        }
    }
}

/// Copies the sixes from `first` on, as many as there are.
pub(super) fn copy_from<T: Copy>(sixes: &[[T; 6]], first: usize, to: &mut [[T; 6]; 6]) {
    for (place, six) in to.iter_mut().zip(sixes.iter().skip(first)) {
        *place = *six;
    }
}

/// Room for the modes of a body that keeps them; `()` for bodies that never do.
pub trait Keeping<V: ModalVector<T>, T: RealField + Copy> {
    /// What is kept, if it is.
    fn kept(&self) -> Option<&KeptModes<V, T>>;
    /// The same, to write to.
    fn kept_mut(&mut self) -> Option<&mut KeptModes<V, T>>;
}

impl<V: ModalVector<T>, T: RealField + Copy> Keeping<V, T> for () {
    #[inline(always)]
    fn kept(&self) -> Option<&KeptModes<V, T>> {
        None
    }

    #[inline(always)]
    fn kept_mut(&mut self) -> Option<&mut KeptModes<V, T>> {
        None
    }
}

impl<V: ModalVector<T>, T: RealField + Copy> Keeping<V, T> for Option<KeptModes<V, T>> {
    fn kept(&self) -> Option<&KeptModes<V, T>> {
        self.as_ref()
    }

    fn kept_mut(&mut self) -> Option<&mut KeptModes<V, T>> {
        self.as_mut()
    }
}
