//! Simulates a case of the comparison with one method and one step, and prints its time and what it observed.
//!
//! `work_precision CASE start` prints the initial state; `work_precision CASE METHOD STEP DURATION SAMPLES ROUNDS` one line of
//! JSON: the least of so many runs' seconds, and the observed points at so many equidistant times.
#![forbid(unsafe_code)]

mod advance;
#[cfg(feature = "rotor")]
mod rotor;
mod slider_crank;

use advance::Request;

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [case, rest @ ..] = arguments.as_slice() else { return Err("which case?".to_owned()) };
    let request = Request::parse(rest)?;
    let line = match case.as_str() {
        "slider_crank" => slider_crank::run(&request)?,
        #[cfg(feature = "rotor")]
        "rotor" => rotor::run(&request)?,
        other => return Err(format!("unknown case `{other}`")),
    };
    println!("{line}");
    Ok(())
}
