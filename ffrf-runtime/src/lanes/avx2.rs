//! The registers of x86-64 processors with AVX2 and fused multiply-add, found when running.

use core::arch::x86_64::{__m128, __m256, __m256d};
use core::ops::{Add, Mul, Sub};

use pulp::cast;
use pulp::x86::V3;

use super::{Four, Lanes, Processor, Registers, Width};
use crate::math::{always_fused_multiply_add, always_fused_multiply_add_f32};

/// Proof that the processor has AVX2 and fused multiply-add.
#[derive(Debug, Clone, Copy)]
pub struct Avx2(V3);

impl Avx2 {
    /// The proof, if the processor has them: a look at one byte, but for the first time.
    #[inline(always)]
    pub fn find() -> Option<Self> {
        V3::try_new().map(Self)
    }

    /// The proof of a processor that has more.
    #[cfg(feature = "host-avx512")]
    #[inline(always)]
    pub(super) fn of(processor: V3) -> Self {
        Self(processor)
    }
}

/// A variable with the size and the alignment of a register.
#[repr(C, align(32))]
struct RegisterSized([u64; 4]);

impl Processor for Avx2 {
    const IS_COMPILED_FOR: bool = false;

    #[inline(always)]
    fn run<O>(self, work: impl FnOnce() -> O) -> O {
        self.0.vectorize(
            #[inline(always)]
            || {
                // Compilers align the stack for variables, not for registers that they run out of: one that is there.
                core::hint::black_box(&mut RegisterSized([0; 4]));
                work()
            },
        )
    }
}

/// A register, with the proof that it is there.
#[derive(Debug, Clone, Copy)]
pub struct Avx2Lanes<V> {
    processor: V3,
    lanes: V,
}

macro_rules! operators {
    ($($trait:ident $method:ident $f64x4:ident $f32x4:ident $f32x8:ident;)*) => {$(
        operators! { $trait $method: __m256d avx $f64x4, __m128 sse $f32x4, __m256 avx $f32x8 }

        impl $trait for Avx2Lanes<[__m256d; 2]> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ([a, b], [c, d]) = (self.halves(), other.halves());
                Self::of(a.$method(c), b.$method(d))
            }
        }
    )*};
    ($trait:ident $method:ident: $($register:ident $feature:ident $operation:ident),*) => {$(
        impl $trait for Avx2Lanes<$register> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let lanes = self.processor.$feature.$operation(self.lanes, other.lanes);
                Self { lanes, ..self }
            }
        }
    )*};
}

operators! {
    Add add _mm256_add_pd _mm_add_ps _mm256_add_ps;
    Sub sub _mm256_sub_pd _mm_sub_ps _mm256_sub_ps;
    Mul mul _mm256_mul_pd _mm_mul_ps _mm256_mul_ps;
}

macro_rules! lanes {
    ($($register:ident: $scalar:ty, $count:literal, $add:ident, $subtract:ident, $feature:ident $splat:ident, $sum:ident;)*) => {$(
        impl Lanes<$scalar, $count> for Avx2Lanes<$register> {
            #[inline(always)]
            fn like(self, numbers: &[$scalar; $count]) -> Self {
                Self { lanes: cast(*numbers), ..self }
            }

            #[inline(always)]
            fn store(self) -> [$scalar; $count] {
                cast(self.lanes)
            }

            #[inline(always)]
            fn multiply_add(self, factor: Self, term: Self) -> Self {
                Self { lanes: self.processor.fma.$add(self.lanes, factor.lanes, term.lanes), ..self }
            }

            #[inline(always)]
            fn subtract_from(self, factor: Self, term: Self) -> Self {
                Self { lanes: self.processor.fma.$subtract(self.lanes, factor.lanes, term.lanes), ..self }
            }

            #[inline(always)]
            fn sum(self) -> $scalar {
                $sum(self.store())
            }
        }

        impl Width<$scalar, $count> for Avx2 {
            type Lanes = Avx2Lanes<$register>;

            #[inline(always)]
            fn load(self, numbers: &[$scalar; $count]) -> Self::Lanes {
                Avx2Lanes { processor: self.0, lanes: cast(*numbers) }
            }

            #[inline(always)]
            fn splat(self, number: $scalar) -> Self::Lanes {
                Avx2Lanes { processor: self.0, lanes: self.0.$feature.$splat(number) }
            }
        }
    )*};
}

lanes! {
    __m256d: f64, 4, _mm256_fmadd_pd, _mm256_fnmadd_pd, avx _mm256_set1_pd, halving;
    __m128: f32, 4, _mm_fmadd_ps, _mm_fnmadd_ps, sse _mm_set1_ps, one_by_one;
    __m256: f32, 8, _mm256_fmadd_ps, _mm256_fnmadd_ps, avx _mm256_set1_ps, halving;
}

/// As the compiler has it where the target has AVX.
#[inline(always)]
fn one_by_one(lanes: [f32; 4]) -> f32 {
    lanes.iter().sum()
}

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

impl Avx2Lanes<[__m256d; 2]> {
    #[inline(always)]
    fn of(low: Avx2Lanes<__m256d>, high: Avx2Lanes<__m256d>) -> Self {
        Self { processor: low.processor, lanes: [low.lanes, high.lanes] }
    }

    #[inline(always)]
    fn halves(self) -> [Avx2Lanes<__m256d>; 2] {
        self.lanes.map(|lanes| Avx2Lanes { processor: self.processor, lanes })
    }
}

impl Lanes<f64, 8> for Avx2Lanes<[__m256d; 2]> {
    #[inline(always)]
    fn like(self, numbers: &[f64; 8]) -> Self {
        Self { lanes: cast(*numbers), ..self }
    }

    #[inline(always)]
    fn store(self) -> [f64; 8] {
        cast(self.lanes)
    }

    #[inline(always)]
    fn multiply_add(self, factor: Self, term: Self) -> Self {
        let ([a, b], [c, d], [e, f]) = (self.halves(), factor.halves(), term.halves());
        Self::of(a.multiply_add(c, e), b.multiply_add(d, f))
    }

    #[inline(always)]
    fn subtract_from(self, factor: Self, term: Self) -> Self {
        let ([a, b], [c, d], [e, f]) = (self.halves(), factor.halves(), term.halves());
        Self::of(a.subtract_from(c, e), b.subtract_from(d, f))
    }

    #[inline(always)]
    fn sum(self) -> f64 {
        let [low, high] = self.halves();
        (low + high).sum()
    }
}

impl Width<f64, 8> for Avx2 {
    type Lanes = Avx2Lanes<[__m256d; 2]>;

    #[inline(always)]
    fn load(self, numbers: &[f64; 8]) -> Self::Lanes {
        Avx2Lanes { processor: self.0, lanes: cast(*numbers) }
    }

    #[inline(always)]
    fn splat(self, number: f64) -> Self::Lanes {
        let half = Width::<f64, 4>::splat(self, number);
        Avx2Lanes::of(half, half)
    }
}

macro_rules! registers {
    ($($register:ident: $scalar:ty, $multiply_add:path, $has_room:literal;)*) => {$(
        impl Four<$scalar> for Avx2Lanes<$register> {
            #[inline(always)]
            fn transpose(rows: [Self; 4]) -> [Self; 4] {
                let numbers = rows.map(Lanes::store);
                core::array::from_fn(|i| rows[i].like(&numbers.map(|row: [$scalar; 4]| row[i])))
            }
        }

        impl Registers<$scalar> for Avx2 {
            const HAS_ROOM_FOR_EIGHTS: bool = $has_room;

            #[inline(always)]
            fn multiply_add(self, a: $scalar, b: $scalar, c: $scalar) -> $scalar {
                $multiply_add(a, b, c)
            }
        }
    )*};
}

registers! {
    __m256d: f64, always_fused_multiply_add, false;
    __m128: f32, always_fused_multiply_add_f32, true;
}
