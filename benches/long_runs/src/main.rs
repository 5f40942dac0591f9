//! Runs of millions of steps: free spin beside the intermediate axis, and a flexible rotor in single against double precision.
//!
//! usage: long_runs free_spin|rotor prints a table of `benches/long_runs.md`, which `benches/long_runs.sh` writes.

mod free_spin;
mod rotor;

fn main() {
    match std::env::args().nth(1).as_deref() {
        Some("free_spin") => free_spin::table(),
        Some("rotor") => rotor::table(),
        other => {
            eprintln!("expected free_spin or rotor, found {other:?}");
            std::process::exit(2);
        }
    }
}
