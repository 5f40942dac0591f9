//! The cases on the desktop: `desktop STEPS [NAME...]` prints name, steps and hash of every case, or of those named;
//! `desktop loop TICKS` prints the hash that a program with a 1 kHz timer must have after so many ticks.
#![forbid(unsafe_code)]

use std::process::ExitCode;

use cases::{Hash, Motion, flying_four_f32, slider_crank_four_f32};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [first, ticks] = arguments.as_slice()
        && first == "loop"
        && let Ok(ticks) = ticks.parse()
    {
        return ticked(ticks);
    }
    let Some((Ok(steps), names)) = arguments.split_first().map(|(steps, names)| (steps.parse(), names))
    else {
        eprintln!("usage: desktop STEPS [NAME...]");
        return ExitCode::from(2);
    };
    let mut every_step_was_taken = true;
    for case in
        cases::CASES.iter().filter(|case| names.is_empty() || names.iter().any(|name| name == case.name))
    {
        (case.run)(steps, &mut |done, hash| {
            every_step_was_taken &= done > 0;
            println!("{} {done} {hash:016x}", case.name);
        });
    }
    if every_step_was_taken { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// What the loop with a timer does, without the timer.
fn ticked(ticks: u32) -> ExitCode {
    let (mut rod, mut crank) = (flying_four_f32(), slider_crank_four_f32());
    let mut hash = Hash::default();
    for _ in 0..ticks {
        if !(rod.step() && crank.step()) {
            return ExitCode::FAILURE;
        }
        rod.hash(&mut hash);
        crank.hash(&mut hash);
    }
    println!("loop {ticks} {:016x}", hash.0);
    ExitCode::SUCCESS
}
