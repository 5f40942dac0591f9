//! The scalar types of the kernels.

use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use super::{Four, HasLanes, Lanes};
use crate::generated_support::{fused_multiply_add, fused_multiply_add_f32};

/// A scalar with registers of four and eight lanes.
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
    /// 0.
    const ZERO: Self;
    /// 1/2.
    const HALF: Self;
    /// 1.
    const ONE: Self;
    /// 2.
    const TWO: Self;
    /// `self * factor + term`, fused where the target does that in hardware.
    fn multiply_add(self, factor: Self, term: Self) -> Self;
}

impl Scalar for f64 {
    const ZERO: Self = 0.0;
    const HALF: Self = 0.5;
    const ONE: Self = 1.0;
    const TWO: Self = 2.0;

    #[inline(always)]
    fn multiply_add(self, factor: Self, term: Self) -> Self {
        fused_multiply_add(self, factor, term)
    }
}

impl Scalar for f32 {
    const ZERO: Self = 0.0;
    const HALF: Self = 0.5;
    const ONE: Self = 1.0;
    const TWO: Self = 2.0;

    #[inline(always)]
    fn multiply_add(self, factor: Self, term: Self) -> Self {
        fused_multiply_add_f32(self, factor, term)
    }
}

/// A register of four lanes.
pub(super) type Register<T> = <T as HasLanes<4>>::Lanes;

/// The numbers in groups of four, padded with zero. `G` groups must hold them all.
#[inline(always)]
pub(super) fn groups<T: Scalar, const M: usize, const G: usize>(numbers: &[T; M]) -> [Register<T>; G] {
    grouped(numbers)
}

/// [`groups`] of a slice.
#[inline(always)]
pub(super) fn grouped<T: Scalar, const G: usize>(numbers: &[T]) -> [Register<T>; G] {
    let mut groups = [Register::<T>::ZERO; G];
    let (whole, rest) = numbers.as_chunks::<4>();
    for (group, numbers) in groups.iter_mut().zip(whole) {
        *group = Lanes::load(numbers);
    }
    if let (false, Some(group)) = (rest.is_empty(), groups.last_mut()) {
        let mut padded = [T::ZERO; 4];
        for (place, number) in padded.iter_mut().zip(rest) {
            *place = *number;
        }
        *group = Lanes::load(&padded);
    }
    groups
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
