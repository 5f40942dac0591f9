//! How deep a piece of work reaches into the stack: the stack below is painted first, and looked at afterwards.

use cortex_m::register::msp;

use crate::machine;

/// What untouched stack holds; no number, and no address, that work would leave by chance in every word.
const PAINT: u32 = 0xa5c3_5ac3;

/// Bytes of stack that `work` takes, its own frame included, at most `depth`; exactly `depth` means that it was not enough.
///
/// Interrupts that come meanwhile count: a frame of up to 104 bytes for each.
#[inline(never)]
pub fn used(depth: u32, mut work: impl FnMut()) -> u32 {
    let top = msp::read();
    let bottom = top.saturating_sub(depth);
    machine::paint(bottom, top, PAINT);
    work();
    top.saturating_sub(machine::first_changed(bottom, top, PAINT))
}
