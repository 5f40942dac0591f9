//! Frequencies and eigenvalues.

use std::f64::consts::TAU;

/// Frequency of an eigenvalue ω². Negative ones, which only round-off makes, count as zero.
pub(crate) fn hertz(value: f64) -> f64 {
    value.max(0.0).sqrt() / TAU
}

/// ω² of a frequency.
pub(crate) fn eigenvalue(hertz: f64) -> f64 {
    (TAU * hertz).powi(2)
}
