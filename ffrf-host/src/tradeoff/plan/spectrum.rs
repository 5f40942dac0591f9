//! How fast something changes: the frequency below which most of its power is.

use std::f64::consts::TAU;

/// The share of the power that is looked for: what is left above is a third in size.
const MOST: f64 = 0.9;

/// The frequency below which `MOST` of the power of the changes of `values` is; zero of what does not change. `interval`: s.
///
/// Frequencies are told apart by one over the duration, and up to half of one over the interval. Units: Hz.
pub(super) fn highest_frequency(values: &[f64], interval: f64) -> f64 {
    let count = values.len();
    let mean = values.iter().sum::<f64>() / count.max(1) as f64;
    let power = |line: usize| {
        let turn = TAU * line as f64 / count as f64;
        let (mut cosine, mut sine) = (0.0, 0.0);
        for (k, value) in values.iter().enumerate() {
            // a window that goes to zero at both ends, so that a slow change is not taken for a fast one
            let window = 0.5 - 0.5 * (TAU * k as f64 / count as f64).cos();
            let (s, c) = (turn * k as f64).sin_cos();
            cosine += window * (value - mean) * c;
            sine += window * (value - mean) * s;
        }
        cosine * cosine + sine * sine
    };
    let lines: Vec<f64> = (1..=count / 2).map(power).collect();
    let total: f64 = lines.iter().sum();
    if total <= f64::MIN_POSITIVE {
        return 0.0;
    }
    let mut below = 0.0;
    let reached = lines.iter().position(|power| {
        below += power;
        below >= MOST * total
    });
    reached.map_or(0.0, |line| (line + 1) as f64 / (count as f64 * interval))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tone_is_found_and_what_rests_has_none() {
        let interval = 1e-3;
        let tone = |frequency: f64| -> Vec<f64> {
            (0..200).map(|k| 3.0 + (TAU * frequency * interval * k as f64).sin()).collect()
        };
        for frequency in [20.0, 100.0, 333.0] {
            // the window spreads a tone over a line on each side, 5 Hz each
            let found = highest_frequency(&tone(frequency), interval);
            assert!((found - frequency).abs() <= 10.0, "{frequency}: {found}");
        }
        assert_eq!(highest_frequency(&[2.0; 50], interval), 0.0);
        assert_eq!(highest_frequency(&[], interval), 0.0);
    }
}
