//! One number as a register of one lane, which nalgebra asks of all its numbers.
//!
//! The trait has two methods with `unsafe` in their signatures, for lanes that are not asked whether they are there. Here
//! they do what the others do, and nothing in them is unsafe.
#![allow(unsafe_code)]

use nalgebra::SimdValue;

use crate::Traced;

impl SimdValue for Traced {
    const LANES: usize = 1;
    type Element = Self;
    type SimdBool = bool;

    fn splat(number: Self) -> Self {
        number
    }

    fn extract(&self, _: usize) -> Self {
        *self
    }

    unsafe fn extract_unchecked(&self, _: usize) -> Self {
        *self
    }

    fn replace(&mut self, _: usize, number: Self) {
        *self = number;
    }

    unsafe fn replace_unchecked(&mut self, _: usize, number: Self) {
        *self = number;
    }

    fn select(self, is_first: bool, other: Self) -> Self {
        if is_first { self } else { other }
    }
}
