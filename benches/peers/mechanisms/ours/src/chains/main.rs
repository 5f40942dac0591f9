//! Times one evaluation of constrained accelerations of chains, stars and trees: `chains ROUNDS`, a line of JSON each.
//!
//! An evaluation is what an explicit integrator calls: bodies, joints, factorisation, accelerations of every body.
#![forbid(unsafe_code)]

mod dense;
mod flexible;
mod pendulum;

use std::hint::black_box;
use std::time::Instant;

/// About the time of one round. Units: s.
const ROUND: f64 = 1e-4;

/// Least time of one call in so many rounds. Units: ns.
fn least<R>(rounds: usize, mut call: impl FnMut() -> R) -> f64 {
    let begin = Instant::now();
    black_box(call());
    let calls = (ROUND / begin.elapsed().as_secs_f64().max(1e-9)).ceil().max(1.0) as usize;
    let mut best = f64::INFINITY;
    for _ in 0..rounds {
        let begin = Instant::now();
        for _ in 0..calls {
            black_box(call());
        }
        best = best.min(begin.elapsed().as_secs_f64() / calls as f64);
    }
    best * 1e9
}

/// One result.
fn report(column: &str, bodies: usize, nanoseconds: f64, check: &[f64]) {
    println!("{{\"column\": \"{column}\", \"n\": {bodies}, \"ns\": {nanoseconds:.1}, \"check\": {check:?}}}");
}

fn main() -> Result<(), String> {
    let rounds = std::env::args().nth(1).and_then(|word| word.parse().ok()).ok_or("how many rounds?")?;
    flexible::run(rounds);
    pendulum::run(rounds)?;
    dense::run(rounds);
    Ok(())
}
