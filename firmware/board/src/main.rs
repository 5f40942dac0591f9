//! The cases on a Cortex-M: `hashes STEPS [NAME...]` prints what `desktop` prints, `loop TICKS` steps at 1 kHz.
#![no_std]
#![no_main]

mod hashes;
mod tick;

use cortex_m_rt::{entry, exception};
use probe::arguments::{Arguments, number};
use probe::{clock, output};

#[entry]
fn main() -> ! {
    let arguments = Arguments::read();
    let mut words = arguments.words();
    let (what, count) = (words.next(), words.next().and_then(number));
    let succeeded = match (what, count) {
        (Some("hashes"), Some(steps)) => hashes::run(steps, words),
        (Some("loop"), Some(ticks)) => tick::run(ticks),
        _ => {
            output::text("usage: hashes STEPS [NAME...] | loop TICKS\n");
            false
        }
    };
    probe::finish(succeeded)
}

#[exception]
fn SysTick() {
    clock::tick();
}

#[exception]
unsafe fn HardFault(_: &cortex_m_rt::ExceptionFrame) -> ! {
    output::text("hard fault\n");
    probe::finish(false)
}
