//! Time per call: many short rounds, the columns taking turns, so that other work on the machine hits all alike.

use std::hint::black_box;
use std::time::Instant;

/// Length of a round in nanoseconds.
const ROUND: f64 = 150_000.0;

/// One column: a name and a call for state number `k`.
pub struct Column<'a> {
    /// What is timed.
    pub name: String,
    /// Evaluates one state.
    pub call: Box<dyn FnMut(usize) + 'a>,
}

/// Nanoseconds per call.
#[derive(Debug, Clone, Copy)]
pub struct Time {
    /// Least of all rounds.
    pub minimum: f64,
    /// Median of all rounds.
    pub median: f64,
}

/// Times every column over `rounds` rounds.
pub fn time(columns: &mut [Column<'_>], rounds: usize) -> Vec<Time> {
    let mut lengths = Vec::new();
    for column in columns.iter_mut() {
        run(column, 64);
        let single = run(column, 64);
        lengths.push(((ROUND / single).ceil() as usize).max(1));
    }
    let mut times = vec![Vec::with_capacity(rounds); columns.len()];
    for _ in 0..rounds {
        for ((column, times), calls) in columns.iter_mut().zip(&mut times).zip(&lengths) {
            times.push(run(column, *calls));
        }
    }
    times
        .into_iter()
        .map(|mut times| {
            times.sort_by(f64::total_cmp);
            Time { minimum: times[0], median: times[times.len() / 2] }
        })
        .collect()
}

/// Nanoseconds per call of `calls` calls.
fn run(column: &mut Column<'_>, calls: usize) -> f64 {
    let start = Instant::now();
    for k in 0..calls {
        (column.call)(black_box(k % 32));
    }
    start.elapsed().as_nanos() as f64 / calls as f64
}
