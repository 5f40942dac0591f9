//! One state, the same for both.

use core::hint::black_box;

include!(concat!(env!("OUT_DIR"), "/body.rs"));

/// q, q̇, ω, force, as both take them.
#[allow(dead_code)] // the baseline reads the force alone
pub struct State {
    pub q: [Scalar; MODES],
    pub q_dot: [Scalar; MODES],
    pub omega: [Scalar; 3],
    pub force: [Scalar; ALL],
}

pub fn state() -> State {
    let mut state =
        State { q: [1e-5; MODES], q_dot: [0.5; MODES], omega: [0.3, 6.0, 0.1], force: [1.5; ALL] };
    for (k, rate) in state.q_dot.iter_mut().enumerate() {
        *rate += 0.125 * k as Scalar;
    }
    black_box(state)
}

/// Prints the bits of each number in double precision.
pub fn show(numbers: &[Scalar]) {
    for number in numbers {
        probe::output::text("result ");
        probe::output::hexadecimal(f64::from(*number).to_bits());
        probe::output::text("\n");
    }
}
