//! The registers of x86-64 processors with AVX2 and fused multiply-add, or with AVX-512, found when running.
//!
//! The two give the same bits: sums over lanes are taken in one order.

use core::ops::Add;

use fearless_simd::prelude::{SimdFloat, SimdFrom};
use fearless_simd::x86::{Avx2, Avx512};
use fearless_simd::{Simd, f32x4, f32x8, f64x4, f64x8};

use super::{Four, Lanes, Processor, Registers, Width};
use crate::math::{always_fused_multiply_add, always_fused_multiply_add_f32};

/// Lane k and lane k + W/2 first, as often as there are two halves.
#[inline(always)]
fn halving<T: Copy + Add<Output = T>, const W: usize>(mut lanes: [T; W]) -> T {
    let mut count = W;
    while count > 1 {
        count /= 2;
        for k in 0..count {
            lanes[k] = lanes[k] + lanes[k + count];
        }
    }
    lanes[0]
}

/// As the compiler has it where the target has AVX.
#[inline(always)]
fn one_by_one(lanes: [f32; 4]) -> f32 {
    lanes.iter().sum()
}

macro_rules! lanes {
    ($($register:ident: $scalar:ty, $count:literal, $sum:ident;)*) => {$(
        impl<S: Simd> Lanes<$scalar, $count> for $register<S> {
            #[inline(always)]
            fn like(self, numbers: &[$scalar; $count]) -> Self {
                Self::simd_from(self.simd, *numbers)
            }

            #[inline(always)]
            fn store(self) -> [$scalar; $count] {
                self.into()
            }

            #[inline(always)]
            fn multiply_add(self, factor: Self, term: Self) -> Self {
                self.mul_add_precise(factor, term)
            }

            #[inline(always)]
            fn subtract_from(self, factor: Self, term: Self) -> Self {
                (-self).mul_add_precise(factor, term)
            }

            #[inline(always)]
            fn sum(self) -> $scalar {
                $sum(self.store())
            }
        }
    )*};
}

lanes! {
    f64x4: f64, 4, halving;
    f64x8: f64, 8, halving;
    f32x4: f32, 4, one_by_one;
    f32x8: f32, 8, halving;
}

macro_rules! fours {
    ($($register:ident: $scalar:ty;)*) => {$(
        impl<S: Simd> Four<$scalar> for $register<S> {
            #[inline(always)]
            fn transpose(rows: [Self; 4]) -> [Self; 4] {
                let numbers = rows.map(Lanes::store);
                core::array::from_fn(|i| rows[i].like(&numbers.map(|row: [$scalar; 4]| row[i])))
            }
        }
    )*};
}

fours! {
    f64x4: f64;
    f32x4: f32;
}

/// A variable with the size and the alignment of the largest register.
#[repr(C, align(64))]
struct RegisterSized([u64; 8]);

macro_rules! processors {
    ($($processor:ident)*) => {$(
        impl Processor for $processor {
            const IS_COMPILED_FOR: bool = false;

            #[inline(always)]
            fn run<O>(self, work: impl FnOnce() -> O) -> O {
                self.vectorize(
                    #[inline(always)]
                    || {
                        // Compilers align the stack for variables, not for registers that they run out of: one that is there.
                        core::hint::black_box(&mut RegisterSized([0; 8]));
                        work()
                    },
                )
            }
        }

        widths! { $processor: f64x4 f64 4, f64x8 f64 8, f32x4 f32 4, f32x8 f32 8 }
    )*};
}

macro_rules! widths {
    ($processor:ident: $($register:ident $scalar:ident $count:literal),*) => {$(
        impl Width<$scalar, $count> for $processor {
            type Lanes = $register<Self>;

            #[inline(always)]
            fn load(self, numbers: &[$scalar; $count]) -> Self::Lanes {
                $register::simd_from(self, *numbers)
            }

            #[inline(always)]
            fn splat(self, number: $scalar) -> Self::Lanes {
                $register::simd_from(self, number)
            }
        }
    )*};
}

processors! { Avx2 Avx512 }

macro_rules! registers {
    ($($processor:ident $scalar:ty, $multiply_add:path, $has_room:literal;)*) => {$(
        impl Registers<$scalar> for $processor {
            const HAS_ROOM_FOR_EIGHTS: bool = $has_room;

            #[inline(always)]
            fn multiply_add(self, a: $scalar, b: $scalar, c: $scalar) -> $scalar {
                $multiply_add(a, b, c)
            }
        }
    )*};
}

registers! {
    Avx2 f64, always_fused_multiply_add, false;
    Avx2 f32, always_fused_multiply_add_f32, true;
    Avx512 f64, always_fused_multiply_add, true;
    Avx512 f32, always_fused_multiply_add_f32, true;
}
