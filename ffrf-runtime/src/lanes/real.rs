//! Any number type of nalgebra as a scalar of the loops: dual numbers, for instance.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{ArrayLanes, HasLanes, Scalar};
use crate::math::{Number, constant};

/// A number whose constants are given in f64.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Real<T>(pub T);

macro_rules! operators {
    ($($operator:ident $method:ident, $assigning:ident $assign:ident;)*) => {$(
        impl<T: Number> $operator for Real<T> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }

        impl<T: Number> $assigning for Real<T> {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                self.0.$assign(other.0);
            }
        }
    )*};
}

operators! {
    Add add, AddAssign add_assign;
    Sub sub, SubAssign sub_assign;
}

impl<T: Number> Mul for Real<T> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl<T: Number> Div for Real<T> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl<T: Number> Neg for Real<T> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<T: Number> HasLanes<4> for Real<T> {
    type Lanes = ArrayLanes<Self, 4>;
}

impl<T: Number> HasLanes<8> for Real<T> {
    type Lanes = ArrayLanes<Self, 8>;
}

impl<T: Number> Scalar for Real<T> {
    type Constant = f64;

    #[inline(always)]
    fn constant(number: f64) -> Self {
        Self(constant(number))
    }

    #[inline(always)]
    fn zero() -> Self {
        Self(T::zero())
    }

    #[inline(always)]
    fn half() -> Self {
        Self(constant(0.5))
    }

    #[inline(always)]
    fn one() -> Self {
        Self(T::one())
    }

    #[inline(always)]
    fn two() -> Self {
        Self(constant(2.0))
    }

    #[inline(always)]
    fn multiply_add(self, factor: Self, term: Self) -> Self {
        Self(self.0 * factor.0 + term.0)
    }
}

/// The numbers as scalars of the loops.
#[inline(always)]
pub fn reals<T: Copy, const K: usize>(numbers: &[T; K]) -> [Real<T>; K] {
    numbers.map(Real)
}

/// The inverse of [`reals`].
#[inline(always)]
pub fn numbers<T, const K: usize>(reals: [Real<T>; K]) -> [T; K] {
    reals.map(|real| real.0)
}
