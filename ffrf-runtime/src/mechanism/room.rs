//! What the equations need of a body beside its state and its forces.

use nalgebra::RealField;

use super::solved::Solved;
use super::support::Supported;
use super::{AttachedRows, Phase, RigidFrame};
use crate::body::{ModalVector, Span};

/// What the equations need of a body beside its state and its forces: nothing until a method needs it, so that what a method
/// does not need costs nothing but its place.
///
/// `R` has a place for the [`AttachedRows`] of each end of a joint on the body, `K` one for modes that are
/// [kept](super::Keeping).
#[derive(Debug, Clone)]
pub struct Room<V: ModalVector<T>, R, T: RealField + Copy, K = ()> {
    pub(super) rows: R,
    pub(super) solved: Solved<V, T>,
    /// What the unknowns of a body without modes are; else the accelerations of its frame are unknown.
    pub(super) frame: Option<RigidFrame<T>>,
    /// The motions that a support leaves, if they are its unknowns.
    pub(super) supported: Option<Supported<T>>,
    /// One over the diagonal of Z in its components; zero where that is not positive.
    pub(super) yields: Option<[T; 6]>,
    /// A step of the energy-momentum method, and what is shown of it.
    pub(super) span: Option<(Span<V, T>, Phase)>,
    pub(super) kept: K,
}

impl<V, R, T, K> Copy for Room<V, R, T, K>
where
    V: ModalVector<T> + Copy,
    V::Sixes: Copy,
    V::Matrix: Copy,
    V::Factors: Copy,
    R: Copy,
    T: RealField + Copy,
    K: Copy,
{
}

impl<V: ModalVector<T>, R, T: RealField + Copy, K> Room<V, R, T, K> {
    #[inline(always)]
    pub(super) fn new(rows: R, kept: K) -> Self {
        Self { rows, solved: Solved::Nothing, frame: None, supported: None, yields: None, span: None, kept }
    }
}

/// The rows of an attached joint.
#[inline(always)]
pub(super) fn attached<V: ModalVector<T>, T: RealField + Copy>(
    rows: &impl AsRef<[Option<AttachedRows<V, T>>]>,
    slot: usize,
) -> Option<&AttachedRows<V, T>> {
    rows.as_ref().get(slot)?.as_ref()
}
