//! The registers that are found when running: the best that the processor has.

#[cfg(not(all(feature = "host-simd", target_arch = "x86_64")))]
pub use super::{Compiled as Narrow, Compiled as Widest};
#[cfg(all(feature = "host-simd", target_arch = "x86_64"))]
pub use fearless_simd::x86::{Avx2 as Narrow, Avx512 as Widest};

/// `on_registers!(registers => work)`: the work, compiled once for each kind of registers; done in the best that are there.
///
/// What the code is compiled for anyhow is not asked for.
#[doc(hidden)]
#[macro_export]
#[cfg(all(
    feature = "host-simd",
    target_arch = "x86_64",
    not(target_feature = "avx512f"),
    not(all(target_feature = "avx2", target_feature = "fma"))
))]
macro_rules! on_registers {
    ($registers:ident => $work:expr) => {
        match $crate::lanes::Level::new() {
            $crate::lanes::Level::Avx512($registers) => $crate::lanes::Processor::run(
                $registers,
                #[inline(always)]
                || $work,
            ),
            $crate::lanes::Level::Avx2($registers) => $crate::lanes::Processor::run(
                $registers,
                #[inline(always)]
                || $work,
            ),
            _ => {
                let $registers = $crate::lanes::Compiled;
                $work
            }
        }
    };
}

/// The work in AVX-512 if that is there, else as it is compiled, which is for AVX2.
#[doc(hidden)]
#[macro_export]
#[cfg(all(
    feature = "host-simd",
    target_arch = "x86_64",
    not(target_feature = "avx512f"),
    all(target_feature = "avx2", target_feature = "fma")
))]
macro_rules! on_registers {
    ($registers:ident => $work:expr) => {
        match $crate::lanes::Level::new() {
            $crate::lanes::Level::Avx512($registers) => $crate::lanes::Processor::run(
                $registers,
                #[inline(always)]
                || $work,
            ),
            _ => {
                let $registers = $crate::lanes::Compiled;
                $work
            }
        }
    };
}

/// The work in the registers that the code is compiled for.
#[doc(hidden)]
#[macro_export]
#[cfg(not(all(feature = "host-simd", target_arch = "x86_64", not(target_feature = "avx512f"))))]
macro_rules! on_registers {
    ($registers:ident => $work:expr) => {{
        let $registers = $crate::lanes::Compiled;
        $work
    }};
}
