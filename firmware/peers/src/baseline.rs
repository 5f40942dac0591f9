//! The program without the work: what it takes is taken off.
#![no_std]
#![no_main]

mod state;

use cortex_m_rt::entry;
use state::{ALL, Scalar, show, state};

#[inline(never)]
fn measured(out: &mut [Scalar; ALL], force: &[Scalar; ALL]) {
    *out = *force;
}

#[entry]
fn main() -> ! {
    let state = state();
    let mut out = [0.0; ALL];
    let good = probe::measure("nothing", || {
        measured(&mut out, &state.force);
        true
    });
    show(&out);
    probe::finish(good)
}
