//! What a program on an emulated Cortex-M needs to be run and measured.
//!
//! - [`output`]: text and numbers over semihosting, without formatting code, which could panic.
//! - [`arguments`]: what the emulator's command line asks for.
//! - [`clock`]: instructions, counted; the 1 kHz timer.
//! - [`stack`]: bytes of stack that a piece of work touches, by painting.
//! - A panic handler that calls a function which exists nowhere: a program links only if no panic is reachable in it.
//!
//! `unsafe` stands in [`machine`], which reads and writes the machine, and in the panic handler's declaration.
#![no_std]
#![deny(unsafe_code)]

pub mod arguments;
pub mod clock;
pub mod machine;
mod measure;
pub mod output;
pub mod stack;

pub use measure::measure;

use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};

/// Ends the emulation with this verdict.
pub fn finish(succeeded: bool) -> ! {
    loop {
        debug::exit(if succeeded { EXIT_SUCCESS } else { EXIT_FAILURE });
    }
}
