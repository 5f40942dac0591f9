//! The scalar types of the kernels.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{Four, HasLanes};
use crate::math::{fused_multiply_add, fused_multiply_add_f32};

/// A scalar with registers of four and eight lanes.
///
/// f64 and f32 have those of the processor. Any other number type (dual numbers, symbols) gets arrays, see
/// [`ArrayLanes`](super::ArrayLanes), and computes with the same loops.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + HasLanes<4, Lanes: Four<Self>>
    + HasLanes<8>
    + 'static
{
    /// What the constant tables hold: the scalar itself, or the plain number that it is made from.
    type Constant: Copy + 'static;

    /// The scalar of a constant.
    fn constant(constant: Self::Constant) -> Self;
    /// 0.
    fn zero() -> Self;
    /// 1/2.
    fn half() -> Self;
    /// 1.
    fn one() -> Self;
    /// 2.
    fn two() -> Self;
    /// `self * factor + term`, fused where the target does that in hardware.
    fn multiply_add(self, factor: Self, term: Self) -> Self;
}

macro_rules! processor_scalar {
    ($($scalar:ty: $multiply_add:path;)*) => {$(
        impl Scalar for $scalar {
            type Constant = Self;

            #[inline(always)]
            fn constant(constant: Self) -> Self {
                constant
            }

            #[inline(always)]
            fn zero() -> Self {
                0.0
            }

            #[inline(always)]
            fn half() -> Self {
                0.5
            }

            #[inline(always)]
            fn one() -> Self {
                1.0
            }

            #[inline(always)]
            fn two() -> Self {
                2.0
            }

            #[inline(always)]
            fn multiply_add(self, factor: Self, term: Self) -> Self {
                $multiply_add(self, factor, term)
            }
        }
    )*};
}

processor_scalar! {
    f64: fused_multiply_add;
    f32: fused_multiply_add_f32;
}
