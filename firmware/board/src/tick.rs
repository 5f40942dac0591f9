//! A free body and a slider-crank, one step of each with every tick of a 1 kHz timer.

use cases::{Hash, Motion, flying_four_f32, slider_crank_four_f32};
use probe::{clock, output};

/// Takes `ticks` steps in time with the timer; whether all could be taken, none of them late.
pub fn run(ticks: u32) -> bool {
    let (mut rod, mut crank) = (flying_four_f32(), slider_crank_four_f32());
    let (mut hash, mut late) = (Hash::default(), 0);
    if !clock::start_tick() {
        return false;
    }
    let mut taken = 0_u32;
    while taken < ticks {
        let _ = clock::wait(taken);
        taken += 1;
        if !(rod.step() && crank.step()) {
            output::text("a step was refused\n");
            return false;
        }
        rod.hash(&mut hash);
        crank.hash(&mut hash);
        // the next tick must not have come yet
        late += u32::from(clock::has_come(taken));
    }
    output::text("loop ");
    output::decimal(taken);
    output::text(" ");
    output::hexadecimal(hash.0);
    output::text("\nlate ");
    output::decimal(late);
    output::text("\n");
    late == 0
}
