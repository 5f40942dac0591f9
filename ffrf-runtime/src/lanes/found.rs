//! The registers that are found when running: the best that the processor has.

/// `on_registers!(registers => work)`: the work, compiled once for each kind of registers; done in the best that are there.
#[doc(hidden)]
#[macro_export]
#[cfg(all(feature = "host-simd", target_arch = "x86_64"))]
macro_rules! on_registers {
    ($registers:ident => $work:expr) => {
        match $crate::lanes::Avx2::find() {
            ::core::option::Option::Some($registers) => $crate::lanes::Processor::run(
                $registers,
                #[inline(always)]
                || $work,
            ),
            ::core::option::Option::None => {
                let $registers = $crate::lanes::Compiled;
                $work
            }
        }
    };
}

/// `on_registers!(registers => work)`: the work in the registers that the code is compiled for.
#[doc(hidden)]
#[macro_export]
#[cfg(not(all(feature = "host-simd", target_arch = "x86_64")))]
macro_rules! on_registers {
    ($registers:ident => $work:expr) => {{
        let $registers = $crate::lanes::Compiled;
        $work
    }};
}
