//! Name, steps and hash of every case, as the desktop prints them.

use cases::CASES;
use probe::output;

/// Runs all cases, or those named; whether every step could be taken.
pub fn run<'a>(steps: u32, names: impl Iterator<Item = &'a str> + Clone) -> bool {
    let all = names.clone().next().is_none();
    let mut every_step_was_taken = true;
    for case in CASES.iter().filter(|case| all || names.clone().any(|name| name == case.name)) {
        (case.run)(steps, &mut |done, hash| {
            every_step_was_taken &= done > 0;
            output::text(case.name);
            output::text(" ");
            output::decimal(done);
            output::text(" ");
            output::hexadecimal(hash);
            output::text("\n");
        });
    }
    every_step_was_taken
}
