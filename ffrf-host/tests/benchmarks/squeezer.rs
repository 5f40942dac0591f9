//! Andrews' squeezing mechanism: problem `andrews` of the test set for IVP solvers, IFToMM benchmark A03.

use super::run::{near, run_scene};

/// Angles and rates at 0.03 s: PSIDE with tolerance 1e-14. Source: deTestSet, `ex_andrews`; Hairer, Wanner, Solving ordinary
/// differential equations II, VII.7.
const REFERENCE: [(&str, f64); 7] = [
    ("beta", 15.81077119629904),
    ("theta", -15.75637105984298),
    ("gamma", 0.04082224013073101),
    ("phi", -0.5347301163226948),
    ("delta", 0.5244099658805304),
    ("omega", 0.5347301163226948),
    ("epsilon", 1.048080741042263),
];

/// Rates of the crank against the ground and of the lever at the same time, whose bodies turn about z alone.
const CRANK_RATE: f64 = 1139.920302151208;
const LEVER_RATE: f64 = 11.03291221937134;

/// Relative to the largest angle: tolerance 1e-10 per step over some 300 steps, seen through two and a half turns.
const ANGLES: f64 = 1e-8;

#[test]
fn the_squeezer_ends_where_the_test_set_says() {
    let run = run_scene("andrews_squeezer.toml", &[]);
    for (name, expected) in REFERENCE {
        near(name, run.last(name), expected, ANGLES * 15.8);
    }
    near("rate of beta", run.last("crank.angular_velocity.z"), CRANK_RATE, ANGLES * CRANK_RATE);
    near("rate of gamma", run.last("lever.angular_velocity.z"), LEVER_RATE, ANGLES * CRANK_RATE);
    let [position, velocity] = run.drift();
    assert!(position < 1e-13 && velocity < 1e-9, "{position:e}, {velocity:e}");
    eprintln!("{:?}", run.summary.advance);
}
