//! Instructions, counted, and a tick of one millisecond.
//!
//! With `-icount shift=6` the emulator lets 64 ns pass with each instruction, and the board's timer counts every 40 ns: the
//! difference of two readings is 8/5 of the number of instructions, exact but for the rounding of one reading.

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::Peripherals;
use cortex_m::peripheral::syst::SystClkSource;

use crate::machine;

/// Rate of the timers' clock on both boards. Units: Hz.
const CLOCK: u32 = 25_000_000;
/// Rate of the tick. Units: Hz.
const RATE: u32 = 1_000;

static TICKS: AtomicU32 = AtomicU32::new(0);

/// Instructions of `work`, those of the call and of the reading included: take those of nothing away. See the module's text.
#[inline(never)]
pub fn instructions(work: impl FnOnce()) -> u32 {
    let before = machine::timer();
    work();
    let ticks = before.wrapping_sub(machine::timer());
    (u64::from(ticks) * 5 / 8) as u32
}

/// Starts the tick; whether there was a timer to start.
pub fn start_tick() -> bool {
    let Some(mut peripherals) = Peripherals::take() else { return false };
    peripherals.SYST.set_clock_source(SystClkSource::Core);
    peripherals.SYST.set_reload(CLOCK / RATE - 1);
    peripherals.SYST.clear_current();
    peripherals.SYST.enable_counter();
    peripherals.SYST.enable_interrupt();
    true
}

/// Sleeps until a tick has come that was not yet taken; how many have.
pub fn wait(taken: u32) -> u32 {
    loop {
        let come = TICKS.load(Ordering::Acquire).wrapping_sub(taken);
        if come > 0 {
            return come;
        }
        cortex_m::asm::wfi();
    }
}

/// Whether a tick has come that was not yet taken.
pub fn has_come(taken: u32) -> bool {
    TICKS.load(Ordering::Acquire) != taken
}

/// To be called in the interrupt of the tick.
pub fn tick() {
    TICKS.fetch_add(1, Ordering::AcqRel);
}
