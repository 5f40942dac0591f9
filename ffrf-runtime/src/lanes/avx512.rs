//! The registers of x86-64 processors with AVX-512, found when running.

use core::arch::x86_64::__m512d;
use core::ops::{Add, Mul, Sub};

use pulp::cast;
use pulp::x86::V4;

use super::avx2::Avx2;
use super::{Four, Lanes, Processor, Registers, Width};

/// Proof that the processor has AVX-512.
#[derive(Debug, Clone, Copy)]
pub struct Avx512(V4);

impl Avx512 {
    /// The proof, if the processor has it.
    #[inline(always)]
    pub fn find() -> Option<Self> {
        V4::try_new().map(Self)
    }

    #[inline(always)]
    fn narrow(self) -> Avx2 {
        Avx2::of(*self.0)
    }
}

/// A variable with the size and the alignment of a register, as for AVX2.
#[repr(C, align(64))]
struct RegisterSized([u64; 8]);

impl Processor for Avx512 {
    const IS_COMPILED_FOR: bool = false;

    #[inline(always)]
    fn run<O>(self, work: impl FnOnce() -> O) -> O {
        self.0.vectorize(
            #[inline(always)]
            || {
                core::hint::black_box(&mut RegisterSized([0; 8]));
                work()
            },
        )
    }
}

/// A register, with the proof that it is there.
#[derive(Debug, Clone, Copy)]
pub struct Avx512Lanes {
    processor: V4,
    lanes: __m512d,
}

macro_rules! operators {
    ($($trait:ident $method:ident $operation:ident;)*) => {$(
        impl $trait for Avx512Lanes {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self { lanes: self.processor.avx512f.$operation(self.lanes, other.lanes), ..self }
            }
        }
    )*};
}

operators! {
    Add add _mm512_add_pd;
    Sub sub _mm512_sub_pd;
    Mul mul _mm512_mul_pd;
}

impl Lanes<f64, 8> for Avx512Lanes {
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
        Self { lanes: self.processor.avx512f._mm512_fmadd_pd(self.lanes, factor.lanes, term.lanes), ..self }
    }

    #[inline(always)]
    fn subtract_from(self, factor: Self, term: Self) -> Self {
        Self { lanes: self.processor.avx512f._mm512_fnmadd_pd(self.lanes, factor.lanes, term.lanes), ..self }
    }

    #[inline(always)]
    fn sum(self) -> f64 {
        let [a, b, c, d, e, f, g, h] = self.store();
        // Halves first, as with AVX2.
        ((a + e) + (c + g)) + ((b + f) + (d + h))
    }
}

impl Width<f64, 8> for Avx512 {
    type Lanes = Avx512Lanes;

    #[inline(always)]
    fn load(self, numbers: &[f64; 8]) -> Self::Lanes {
        Avx512Lanes { processor: self.0, lanes: cast(*numbers) }
    }

    #[inline(always)]
    fn splat(self, number: f64) -> Self::Lanes {
        Avx512Lanes { processor: self.0, lanes: self.0.avx512f._mm512_set1_pd(number) }
    }
}

macro_rules! narrow {
    ($($scalar:ty, $count:literal;)*) => {$(
        impl Width<$scalar, $count> for Avx512 {
            type Lanes = <Avx2 as Width<$scalar, $count>>::Lanes;

            #[inline(always)]
            fn load(self, numbers: &[$scalar; $count]) -> Self::Lanes {
                Width::<$scalar, $count>::load(self.narrow(), numbers)
            }

            #[inline(always)]
            fn splat(self, number: $scalar) -> Self::Lanes {
                Width::<$scalar, $count>::splat(self.narrow(), number)
            }
        }
    )*};
}

narrow! {
    f64, 4;
    f32, 4;
    f32, 8;
}

impl<T> Registers<T> for Avx512
where
    Avx512: Width<T, 4, Lanes: Four<T>> + Width<T, 8>,
    Avx2: Registers<T>,
{
    const HAS_ROOM_FOR_EIGHTS: bool = true;

    #[inline(always)]
    fn multiply_add(self, a: T, b: T, c: T) -> T {
        Registers::<T>::multiply_add(self.narrow(), a, b, c)
    }
}
