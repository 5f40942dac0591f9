//! What a body has of its own in the equations that are solved.

use nalgebra::RealField;

use super::tree::Woven;
use crate::body::{Eliminated, ModalVector};

/// What a body has of its own in the equations that are solved: one or the other, so that it takes the room of one.
#[derive(Debug, Clone)]
pub(super) enum Solved<V: ModalVector<T>, T: RealField + Copy> {
    /// Nothing yet, or nothing that there is.
    Nothing,
    /// The modes eliminated, in the equations of all bodies and joints.
    Rows(Eliminated<V, T>),
    /// The modes in a tree.
    Tree(Woven<V, T>),
}

impl<V, T> Copy for Solved<V, T>
where
    V: ModalVector<T> + Copy,
    V::Sixes: Copy,
    V::Matrix: Copy,
    V::Factors: Copy,
    T: RealField + Copy,
{
}

impl<V: ModalVector<T>, T: RealField + Copy> Solved<V, T> {
    #[inline(always)]
    pub(super) fn of_rows(eliminated: Option<Eliminated<V, T>>) -> Self {
        eliminated.map_or(Self::Nothing, Self::Rows)
    }

    #[inline(always)]
    pub(super) fn eliminated(&self) -> Option<&Eliminated<V, T>> {
        if let Self::Rows(eliminated) = self { Some(eliminated) } else { None }
    }

    #[inline(always)]
    pub(super) fn woven(&self) -> Option<&Woven<V, T>> {
        if let Self::Tree(woven) = self { Some(woven) } else { None }
    }

    #[inline(always)]
    pub(super) fn woven_mut(&mut self) -> Option<&mut Woven<V, T>> {
        if let Self::Tree(woven) = self { Some(woven) } else { None }
    }
}
