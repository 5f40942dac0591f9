//! Registers for scalars that no processor has registers for.

use core::ops::{Add, Mul, Sub};

use super::{Everywhere, Four, Lanes, Scalar};

/// `W` numbers of any scalar type, one after another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArrayLanes<T, const W: usize>([T; W]);

macro_rules! lane_by_lane {
    ($($operator:ident $method:ident)*) => {$(
        impl<T: Scalar, const W: usize> $operator for ArrayLanes<T, W> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(core::array::from_fn(|k| self.0[k].$method(other.0[k])))
            }
        }
    )*};
}

lane_by_lane! { Add add  Sub sub  Mul mul }

impl<T: Scalar, const W: usize> Lanes<T, W> for ArrayLanes<T, W> {
    #[inline(always)]
    fn like(self, numbers: &[T; W]) -> Self {
        Self(*numbers)
    }

    #[inline(always)]
    fn store(self) -> [T; W] {
        self.0
    }

    #[inline(always)]
    fn multiply_add(self, factor: Self, term: Self) -> Self {
        Self(core::array::from_fn(|k| self.0[k].multiply_add(factor.0[k], term.0[k])))
    }

    #[inline(always)]
    fn subtract_from(self, factor: Self, term: Self) -> Self {
        Self(core::array::from_fn(|k| (-self.0[k]).multiply_add(factor.0[k], term.0[k])))
    }

    #[inline(always)]
    fn sum(self) -> T {
        self.0.into_iter().fold(T::zero(), |sum, lane| sum + lane)
    }
}

impl<T: Scalar, const W: usize> Everywhere<T, W> for ArrayLanes<T, W> {
    #[inline(always)]
    fn load(numbers: &[T; W]) -> Self {
        Self(*numbers)
    }

    #[inline(always)]
    fn splat(number: T) -> Self {
        Self([number; W])
    }
}

impl<T: Scalar> Four<T> for ArrayLanes<T, 4> {
    #[inline(always)]
    fn transpose(rows: [Self; 4]) -> [Self; 4] {
        core::array::from_fn(|i| Self(core::array::from_fn(|j| rows[j].0[i])))
    }
}
