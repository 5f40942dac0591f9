//! What the rows of a joint do to the modes of one body.

use nalgebra::RealField;

use crate::body::ModalVector;

/// The rows of a joint on one body: their gradients to the modes, row by row side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AttachedRows<V: ModalVector<T>, T: RealField + Copy = f64> {
    /// Modal part of the gradients. Shape: M x rows.
    pub(super) modal: V::Sixes,
    /// Θ_ff⁻¹ times that, in the equations of all bodies and joints. Shape: M x rows.
    pub(super) weighted: Option<V::Sixes>,
    /// Number of rows.
    pub(super) count: usize,
}

impl<V: ModalVector<T>, T: RealField + Copy> AttachedRows<V, T> {
    /// Rows without effect, where none were.
    #[inline(always)]
    pub(super) fn put<'a>(place: &'a mut Option<Self>, zeros: &V) -> &'a mut Self {
        // made where it stays
        place.get_or_insert_with(|| Self { modal: zeros.zero_sixes(), weighted: None, count: 0 })
    }
}
