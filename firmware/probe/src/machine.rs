//! The machine itself: the only place of this program with `unsafe`, a few lines for each purpose.
#![allow(unsafe_code)]

use core::ptr;

use cortex_m_semihosting::{nr, syscall1};

/// Registers of the first timer of the boards (CMSDK APB timer): control, value, reload.
const TIMER: [*mut u32; 3] = [0x4000_0000 as *mut u32, 0x4000_0004 as *mut u32, 0x4000_0008 as *mut u32];

/// Lets the timer run down from its largest value.
pub fn start_timer() {
    // SAFETY: the registers exist on both boards, and nothing else uses this timer.
    unsafe {
        ptr::write_volatile(TIMER[2], u32::MAX);
        ptr::write_volatile(TIMER[1], u32::MAX);
        ptr::write_volatile(TIMER[0], 1);
    }
}

/// What is left of the timer: it counts down with the board's clock, 25 MHz.
#[inline(always)]
pub fn timer() -> u32 {
    // SAFETY: as above; reading changes nothing.
    unsafe { ptr::read_volatile(TIMER[1]) }
}

/// Writes `pattern` to the words from `low` to `high`, which must be free stack.
#[inline(always)]
pub(crate) fn paint(low: u32, high: u32, pattern: u32) {
    let mut address = low;
    while address < high {
        // SAFETY: the caller (`stack`) gives the part of the stack below the stack pointer, which nothing uses now.
        unsafe { ptr::write_volatile(address as *mut u32, pattern) };
        address = address.wrapping_add(4);
    }
}

/// The first word from `low` up that is not `pattern`.
#[inline(always)]
pub(crate) fn first_changed(low: u32, high: u32, pattern: u32) -> u32 {
    let mut address = low;
    // SAFETY: as for `paint`: words of the stack's own memory, read only.
    while address < high && unsafe { ptr::read_volatile(address as *const u32) } == pattern {
        address = address.wrapping_add(4);
    }
    address
}

/// Copies the command line of the emulator into `buffer`; its length, zero if there is none or it does not fit.
pub(crate) fn command_line(buffer: &mut [u8]) -> usize {
    let mut block = [buffer.as_mut_ptr() as usize, buffer.len()];
    // SAFETY: SYS_GET_CMDLINE (Arm, Semihosting) writes at most so many bytes as the block says, and their number into it.
    let failed = unsafe { syscall1(nr::GET_CMDLINE, block.as_mut_ptr() as usize) };
    if failed == 0 { block[1].min(buffer.len()) } else { 0 }
}

// SAFETY: this function exists nowhere. A program that could reach it does not link.
unsafe extern "C" {
    safe fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    a_panic_is_reachable()
}
