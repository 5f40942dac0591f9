//! What a computation takes of a processor.

use std::time::Instant;

/// Measures the time that this thread computes, without what others take of the processor where the system tells it.
pub(super) struct Stopwatch {
    begin: Instant,
    processor: Option<f64>,
}

/// Below this the system's account of a thread, which it settles every few milliseconds, is too coarse. Units: s.
const COARSE: f64 = 0.1;

impl Stopwatch {
    pub(super) fn start() -> Self {
        Self { begin: Instant::now(), processor: processor_time() }
    }

    /// Time so far. Units: s.
    pub(super) fn seconds(&self) -> f64 {
        let wall = self.begin.elapsed().as_secs_f64();
        match (self.processor, processor_time()) {
            (Some(before), Some(now)) if now - before > COARSE => (now - before).min(wall),
            _ => wall,
        }
    }
}

/// Time that this thread has had a processor, as Linux accounts for it; none elsewhere. Units: s.
fn processor_time() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split_whitespace().next()?.parse::<f64>().ok().map(|nanoseconds| 1e-9 * nanoseconds)
}
