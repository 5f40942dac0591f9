//! Numbers over the modes in groups of four lanes.

use core::ops::Mul;

use super::{Lanes, Registers, Scalar, Width};

/// A register of four lanes.
pub(super) type Register<T, R> = <R as Width<T, 4>>::Lanes;

/// Four numbers in a register.
#[inline(always)]
pub(super) fn load<T: Scalar, R: Registers<T>>(registers: R, numbers: &[T; 4]) -> Register<T, R> {
    Width::<T, 4>::load(registers, numbers)
}

/// One number in every lane.
#[inline(always)]
pub(super) fn splat<T: Scalar, R: Registers<T>>(registers: R, number: T) -> Register<T, R> {
    Width::<T, 4>::splat(registers, number)
}

/// Every lane zero.
#[inline(always)]
pub(super) fn zero<T: Scalar, R: Registers<T>>(registers: R) -> Register<T, R> {
    splat(registers, T::zero())
}

/// A register of constants.
#[inline(always)]
pub(super) fn constants<T: Scalar, R: Width<T, W>, const W: usize>(
    registers: R,
    numbers: &[T::Constant; W],
) -> R::Lanes {
    registers.load(&numbers.map(T::constant))
}

/// [`constants`] of a group of four.
#[inline(always)]
pub(super) fn four<T: Scalar, R: Registers<T>>(registers: R, numbers: &[T::Constant; 4]) -> Register<T, R> {
    constants::<T, R, 4>(registers, numbers)
}

/// The numbers in groups of four, padded with zero. `G` groups must hold them all.
#[inline(always)]
pub(super) fn groups<T: Scalar, R: Registers<T>, const M: usize, const G: usize>(
    registers: R,
    numbers: &[T; M],
) -> [Register<T, R>; G] {
    grouped::<T, R, G>(registers, numbers)
}

/// [`groups`] of a slice.
#[inline(always)]
pub(super) fn grouped<T: Scalar, R: Registers<T>, const G: usize>(
    registers: R,
    numbers: &[T],
) -> [Register<T, R>; G] {
    let mut groups = [zero::<T, R>(registers); G];
    let (whole, rest) = numbers.as_chunks::<4>();
    for (group, numbers) in groups.iter_mut().zip(whole) {
        *group = load(registers, numbers);
    }
    if let (false, Some(group)) = (rest.is_empty(), groups.last_mut()) {
        let mut padded = [T::zero(); 4];
        for (place, number) in padded.iter_mut().zip(rest) {
            *place = *number;
        }
        *group = load(registers, &padded);
    }
    groups
}

/// `factor` times each register.
///
/// Not by `map`: its closure may stay a function apart, compiled for less than what it was part of, where registers that are
/// found when running pass through memory.
#[inline(always)]
pub(super) fn scaled<L: Copy + Mul<Output = L>, const K: usize>(factor: L, mut registers: [L; K]) -> [L; K] {
    for register in &mut registers {
        *register = factor * *register;
    }
    registers
}

/// The lanes of every group as numbers.
#[inline(always)]
pub(super) fn stored<T: Scalar, R: Registers<T>, const G: usize>(
    groups: &[Register<T, R>; G],
) -> [[T; 4]; G] {
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
    use super::super::Compiled;
    use super::*;

    #[test]
    fn groups_are_padded_and_come_back() {
        let numbers = [1.0, 2.0, 3.0, 4.0, 5.0];
        let groups: [Register<f64, Compiled>; 2] = groups(Compiled, &numbers);
        assert_eq!(groups[1].store(), [5.0, 0.0, 0.0, 0.0]);
        let mut back = [0.0; 5];
        ungroup(|g| groups[g].store(), &mut back);
        assert_eq!(back, numbers);
    }
}
