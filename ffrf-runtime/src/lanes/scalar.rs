//! The scalar types of the kernels.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{Four, HasLanes, Lanes};
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

/// A register of four lanes.
pub(super) type Register<T> = <T as HasLanes<4>>::Lanes;

/// A register of constants.
#[inline(always)]
pub(super) fn constants<T: Scalar, R: Lanes<T, W>, const W: usize>(numbers: &[T::Constant; W]) -> R {
    R::load(&numbers.map(T::constant))
}

/// [`constants`] of a group of four.
#[inline(always)]
pub(super) fn four<T: Scalar>(numbers: &[T::Constant; 4]) -> Register<T> {
    constants::<T, Register<T>, 4>(numbers)
}

/// The numbers in groups of four, padded with zero. `G` groups must hold them all.
#[inline(always)]
pub(super) fn groups<T: Scalar, const M: usize, const G: usize>(numbers: &[T; M]) -> [Register<T>; G] {
    grouped(numbers)
}

/// [`groups`] of a slice.
#[inline(always)]
pub(super) fn grouped<T: Scalar, const G: usize>(numbers: &[T]) -> [Register<T>; G] {
    let mut groups = [Register::<T>::zero(); G];
    let (whole, rest) = numbers.as_chunks::<4>();
    for (group, numbers) in groups.iter_mut().zip(whole) {
        *group = Lanes::load(numbers);
    }
    if let (false, Some(group)) = (rest.is_empty(), groups.last_mut()) {
        let mut padded = [T::zero(); 4];
        for (place, number) in padded.iter_mut().zip(rest) {
            *place = *number;
        }
        *group = Lanes::load(&padded);
    }
    groups
}

/// The lanes of every group as numbers.
#[inline(always)]
pub(super) fn stored<T: Scalar, const G: usize>(groups: &[Register<T>; G]) -> [[T; 4]; G] {
    groups.map(Lanes::store)
}

/// The inverse of [`grouped`]: writes the numbers of `group(0)`, `group(1)`, ... one after another.
#[inline(always)]
pub(super) fn ungroup<T: Scalar>(group: impl Fn(usize) -> [T; 4], numbers: &mut [T]) {
    let (whole, rest) = numbers.as_chunks_mut::<4>();
    let count = whole.len();
    for (g, numbers) in whole.iter_mut().enumerate() {
        *numbers = group(g);
    }
    if !rest.is_empty() {
        for (place, number) in rest.iter_mut().zip(group(count)) {
            *place = number;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_padded_and_come_back() {
        let numbers = [1.0, 2.0, 3.0, 4.0, 5.0];
        let groups: [Register<f64>; 2] = groups(&numbers);
        assert_eq!(groups[1].store(), [5.0, 0.0, 0.0, 0.0]);
        let mut back = [0.0; 5];
        ungroup(|g| groups[g].store(), &mut back);
        assert_eq!(back, numbers);
    }
}
