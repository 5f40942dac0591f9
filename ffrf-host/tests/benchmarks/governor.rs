//! IFToMM benchmark A05, the stiff flyball governor.
//!
//! Its library lists no digits, and the number of Exudyn's test (TestModels/stiffFlyballGovernor.py, 0.8962488779) is a
//! velocity that has not yet changed. So the reference is the problem itself in the coordinates of its symmetric motion:
//! the angle α of the rods below the horizontal and the height s of the slider; the angular momentum about the shaft stays.

use super::run::{near, run_scene};

const GRAVITY: f64 = 9.81;
const STIFFNESS: f64 = 8e5;
const DAMPING: f64 = 4e4;
const REST: f64 = 0.5;
/// Distance of hinges and struts from the shaft's axis. Units: m.
const OFFSET: f64 = 0.05;
const SLIDER: f64 = 3.0;
/// Moments of shaft and slider about the axis. Units: kg m².
const TURNING: f64 = 5e-6 + 5e-3;
const ROD: f64 = 5.3;
/// Distance of the centre of mass of rod and ball from the hinge. Units: m.
const CENTRE: f64 = (0.3 * 0.5 + 5.0) / ROD;
/// Moments of a rod with its ball about that centre: along, and across. Units: kg m².
const ALONG: f64 = 0.3 / 12.0 * 2e-4;

fn across() -> f64 {
    0.3 / 12.0 * (1.0 + 1e-4) + 0.3 * (0.5 - CENTRE).powi(2) + 5.0 * (1.0 - CENTRE).powi(2)
}

/// Moment of all about the shaft's axis at α, and its derivative.
fn inertia(alpha: f64) -> [f64; 2] {
    let (sine, cosine) = alpha.sin_cos();
    let radius = OFFSET + CENTRE * cosine;
    let rod = ROD * radius * radius + ALONG * sine * sine + across() * cosine * cosine;
    let change = -2.0 * ROD * radius * CENTRE * sine + 2.0 * (ALONG - across()) * sine * cosine;
    [TURNING + 2.0 * rod, 2.0 * change]
}

/// Rates of [α, α̇, s, ṡ].
fn rates([alpha, turning, height, sliding]: [f64; 4], momentum: f64) -> [f64; 4] {
    let (sine, cosine) = alpha.sin_cos();
    // strut from (0, s) to (½ cos α, 1 - ½ sin α) beside the common offset
    let (x, z) = (0.5 * cosine, 1.0 - 0.5 * sine - height);
    let length = x.hypot(z);
    let by_alpha = (-0.5 * sine * x - 0.5 * cosine * z) / length;
    let by_height = -z / length;
    let pull = STIFFNESS * (length - REST) + DAMPING * (by_alpha * turning + by_height * sliding);
    let [whole, change] = inertia(alpha);
    let spin = momentum / whole;
    // each rod has half of the change of inertia
    let moment = 0.25 * spin * spin * change + ROD * GRAVITY * CENTRE * cosine - pull * by_alpha;
    let force = -SLIDER * GRAVITY - 2.0 * pull * by_height;
    [turning, moment / (across() + ROD * CENTRE * CENTRE), sliding, force / SLIDER]
}

/// [α, α̇, s, ṡ] and the spin at `time`, by RK4 with a step of a third of the fastest decay's time.
fn reference(time: f64) -> ([f64; 4], f64) {
    let mut state = [std::f64::consts::FRAC_PI_6, 0.0, 0.5, 0.0];
    let momentum = inertia(state[0])[0] * 0.16 * std::f64::consts::TAU;
    let count = (time / 1e-5).round() as usize;
    let step = time / count as f64;
    let moved = |state: [f64; 4], slope: [f64; 4], by: f64| std::array::from_fn(|k| state[k] + by * slope[k]);
    for _ in 0..count {
        let a = rates(state, momentum);
        let b = rates(moved(state, a, 0.5 * step), momentum);
        let c = rates(moved(state, b, 0.5 * step), momentum);
        let d = rates(moved(state, c, step), momentum);
        let slope = std::array::from_fn(|k| (a[k] + 2.0 * (b[k] + c[k]) + d[k]) / 6.0);
        state = moved(state, slope, step);
    }
    (state, momentum / inertia(state[0])[0])
}

/// RK4 with 0.08 ms, stable but not exact for the dampers' first milliseconds, which leave little behind.
const POSITION: f64 = 1e-7;
/// What errors of rates, below 1e-7 m/s, make of the force of two dampers. Units: N.
const REACTION: f64 = 1e-7 * 2.0 * DAMPING;

fn check(duration: f64) {
    let replaced = format!("duration = {duration:?}");
    let run = run_scene("governor.toml", &[("duration = 10.0", &replaced)]);
    let ([alpha, turning, height, sliding], spin) = reference(duration);
    near("rods' rate", run.last("rod_a.angular_velocity.y"), turning, 10.0 * POSITION);
    near("slider", run.last("slider.position.z"), height, POSITION);
    near("slider's rate", run.last("slider.velocity.z"), sliding, 10.0 * POSITION);
    near("spin", run.last("shaft.angular_velocity.z"), spin, 10.0 * POSITION);
    // the bearing carries what falls
    let (sine, cosine) = alpha.sin_cos();
    let rates = rates([alpha, turning, height, sliding], spin * inertia(alpha)[0]);
    let falling = 2.0 * ROD * CENTRE * (sine * turning * turning - cosine * rates[1]) + SLIDER * rates[3];
    let weight = (0.3 + SLIDER + 2.0 * ROD) * GRAVITY;
    near("bearing", run.last("bearing.z"), weight + falling, REACTION);
    let [position, velocity] = run.drift();
    assert!(position < 1e-13 && velocity < 1e-10, "{position:e}, {velocity:e}");
}

#[test]
fn the_governor_moves_as_its_two_coordinates_say() {
    check(0.5);
}

#[test]
#[ignore = "125,000 steps: the whole of the benchmark's ten seconds"]
fn the_governor_moves_as_its_two_coordinates_say_for_ten_seconds() {
    check(10.0);
}
