//! The registers that are found when running: the best that the processor has.

#[cfg(all(feature = "host-simd", target_arch = "x86_64"))]
pub use super::Avx2 as Narrow;
#[cfg(all(feature = "host-avx512", target_arch = "x86_64"))]
pub use super::Avx512 as Widest;
#[cfg(not(all(feature = "host-simd", target_arch = "x86_64")))]
pub use super::Compiled as Narrow;
#[cfg(not(all(feature = "host-avx512", target_arch = "x86_64")))]
pub use Narrow as Widest;

/// `on_registers!(registers => work)`: the work, compiled once for each kind of registers; done in the best that are there.
///
/// What the code is compiled for anyhow is not asked for.
#[doc(hidden)]
#[macro_export]
#[cfg(all(feature = "host-avx512", target_arch = "x86_64", not(target_feature = "avx512f")))]
macro_rules! on_registers {
    ($registers:ident => $work:expr) => {
        if let ::core::option::Option::Some($registers) = $crate::lanes::Avx512::find() {
            $crate::lanes::Processor::run(
                $registers,
                #[inline(always)]
                || $work,
            )
        } else {
            $crate::on_narrow_registers!($registers => $work)
        }
    };
}

/// `on_registers!(registers => work)`: the same without AVX-512.
#[doc(hidden)]
#[macro_export]
#[cfg(not(all(feature = "host-avx512", target_arch = "x86_64", not(target_feature = "avx512f"))))]
macro_rules! on_registers {
    ($registers:ident => $work:expr) => {
        $crate::on_narrow_registers!($registers => $work)
    };
}

/// The work with AVX2 if it is there, else in the registers that the code is compiled for.
#[doc(hidden)]
#[macro_export]
#[cfg(all(
    feature = "host-simd",
    target_arch = "x86_64",
    not(all(target_feature = "avx2", target_feature = "fma"))
))]
macro_rules! on_narrow_registers {
    ($registers:ident => $work:expr) => {
        if let ::core::option::Option::Some($registers) = $crate::lanes::Avx2::find() {
            $crate::lanes::Processor::run(
                $registers,
                #[inline(always)]
                || $work,
            )
        } else {
            let $registers = $crate::lanes::Compiled;
            $work
        }
    };
}

/// The work in the registers that the code is compiled for.
#[doc(hidden)]
#[macro_export]
#[cfg(not(all(
    feature = "host-simd",
    target_arch = "x86_64",
    not(all(target_feature = "avx2", target_feature = "fma"))
)))]
macro_rules! on_narrow_registers {
    ($registers:ident => $work:expr) => {{
        let $registers = $crate::lanes::Compiled;
        $work
    }};
}
