//! Instructions and stack of a piece of work, printed.

use crate::{clock, machine, output, stack};

/// How often work is counted.
const REPEATS: u32 = 32;
/// How much stack is painted. Units: bytes.
const DEPTH: u32 = 512 << 10;

/// Prints `NAME most TOTAL stack`: the most instructions of one call, those of all calls together, and the bytes of stack
/// of a call; whether every call succeeded and the stack was found.
///
/// Needs `-icount shift=6`, see [`clock`].
pub fn measure(name: &str, mut work: impl FnMut() -> bool) -> bool {
    machine::start_timer();
    let mut succeeded = true;
    let stack = stack::used(DEPTH, || succeeded &= work());
    let (mut most, mut all) = (0, 0_u32);
    for _ in 0..REPEATS {
        let count = clock::instructions(|| succeeded &= work());
        most = count.max(most);
        all = all.saturating_add(count);
    }
    output::text("measured ");
    output::text(name);
    for number in [most, all / REPEATS, stack] {
        output::text(" ");
        output::decimal(number);
    }
    output::text("\n");
    succeeded && stack < DEPTH
}
