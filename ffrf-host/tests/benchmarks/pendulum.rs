//! IFToMM benchmark A01, a pendulum released horizontally, against its closed form.
//!
//! In elliptic functions, sin(θ/2) = k sn(K - ω₀ t, k) with k = sin(θ₀/2) and ω₀ = √(g / L).
//! Source: <https://www.iftomm-multibody.org/benchmark/problem/Simple_pendulum>: 1 kg at 1 m, 10 s.

use super::run::{near, run_text};

const SCENE: &str = r#"[simulation]
duration = 10.0
step = 2e-3
gravity = [0.0, -9.81, 0.0]
output_step = 0.1

[bodies.bar]          # reduced length 1 m: (0.25 + 1 * 0.5²) / (1 * 0.5); moves as a point of 1 kg at 1 m does
mass = 1.0
center_of_mass = [-0.5, 0.0, 0.0]
inertia = [[0.25, 0.0, 0.0], [0.0, 0.25, 0.0], [0.0, 0.0, 0.25]]

[joints.pin]
kind = "revolute"
first = "ground"
second = "bar"

[sensors.angle]
kind = "angle"
of = "pin"
"#;

/// sn(u, k) and K(k) by the arithmetic-geometric mean. Source: Abramowitz and Stegun, 16.4, 17.6.
fn elliptic(u: f64, k: f64) -> (f64, f64) {
    let (mut a, mut b) = (1.0_f64, (1.0 - k * k).sqrt());
    let mut ratios = Vec::new();
    while (a - b).abs() > 1e-16 * a && ratios.len() < 20 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        ratios.push(c / a);
    }
    let quarter = std::f64::consts::FRAC_PI_2 / a;
    let mut phase = (1_u64 << ratios.len()) as f64 * a * u;
    for ratio in ratios.iter().rev() {
        phase = 0.5 * (phase + (ratio * phase.sin()).asin());
    }
    (phase.sin(), quarter)
}

/// RK4 with h ω = 0.006 over 31 rad: (h ω)⁴ times some rad.
const CLOSED_FORM: f64 = 1e-8;

#[test]
fn the_pendulum_swings_as_elliptic_functions_say() {
    let run = run_text(SCENE, std::path::Path::new(""));
    let (k, omega) = (std::f64::consts::FRAC_PI_4.sin(), 9.81_f64.sqrt());
    let quarter = elliptic(0.0, k).1;
    let mut worst = 0.0_f64;
    for (sample, angle) in run.samples.iter().zip(run.column("angle")) {
        // from the vertical: the body begins to the left, a quarter turn before
        let theta = 2.0 * (k * elliptic(quarter - omega * sample.time, k).0).asin();
        let expected = std::f64::consts::FRAC_PI_2 - theta;
        worst = worst.max((angle - expected).abs());
    }
    near("largest error of the angle", worst, 0.0, CLOSED_FORM);
    near("energy", run.energy_error(), 0.0, CLOSED_FORM);
}
