//! A program that can panic, which must therefore not link: it shows that the proof is one.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use probe::arguments::{Arguments, number};

#[entry]
fn main() -> ! {
    let table = [1_u8, 2, 3];
    let place = Arguments::read().words().next().and_then(number).unwrap_or(7);
    probe::finish(table[place as usize] == 1)
}
