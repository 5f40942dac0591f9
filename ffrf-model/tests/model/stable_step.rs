//! Highest frequency and largest stable step: against closed forms, and against the integrator itself.
#![allow(clippy::unwrap_used)]

use crate::sample;
use ffrf_model::{Inertia, ReducedBody};

/// Two masses on a spring along x, with their relative displacement as the one mode: a free oscillator whose
/// reduced mass is m₁m₂ / (m₁ + m₂), while the mode alone has the mass m₂.
fn oscillator(first: f64, second: f64, stiffness: f64, damping: f64) -> ReducedBody {
    let corner = |position, shape| sample::Point { mass: first / 4.0, position, shapes: vec![shape] };
    // Four corners make the first mass a body with rotational inertia; the second sits in their middle.
    let mut points = vec![
        corner([0.0, 1.0, 0.0], [0.0; 3]),
        corner([0.0, -1.0, 0.0], [0.0; 3]),
        corner([0.0, 0.0, 1.0], [0.0; 3]),
        corner([0.0, 0.0, -1.0], [0.0; 3]),
    ];
    points.push(sample::Point { mass: second, position: [0.0; 3], shapes: vec![[1.0, 0.0, 0.0]] });
    let mut body = sample::body(1);
    body.inertia = sample::inertia(&points);
    body.markers.clear();
    body.stiffness = vec![vec![stiffness]];
    body.damping = vec![vec![damping]];
    body
}

#[test]
fn the_frequency_is_that_of_the_free_body() {
    let body = oscillator(3.0, 1.0, 12.0, 0.0);
    body.check().unwrap().verdict().unwrap();
    let found = body.highest_frequency().unwrap();
    // sqrt(12 / 0.75) = 4; the mode alone would have sqrt(12).
    assert!((found - 4.0).abs() < 1e-14, "{found}");
    assert!((body.largest_stable_step().unwrap() - 2.785 / 4.0).abs() < 1e-14);
}

#[test]
fn modes_of_any_scale_and_mixture_have_the_same_frequency() {
    let body = sample::body(5);
    let expected = body.highest_frequency().unwrap();
    // The frequency of any one mode is lower.
    let mass = body.inertia.modal_mass();
    for mu in 0..5 {
        assert!((body.stiffness[mu][mu] / mass[mu][mu]).sqrt() < expected);
    }
    // New modes: ψ_μ' = Σ mix[μ][ν] ψ_ν, with a dense mass and stiffness.
    let mix = |mu: usize, nu: usize| if mu == nu { 10_f64.powi(mu as i32 - 2) } else { 0.1 };
    let mut points = sample::points(5);
    for point in &mut points {
        let old = point.shapes.clone();
        for mu in 0..5 {
            point.shapes[mu] = [0, 1, 2].map(|i| (0..5).map(|nu| mix(mu, nu) * old[nu][i]).sum());
        }
    }
    let mut mixed = body.clone();
    mixed.inertia = sample::inertia(&points);
    for mu in 0..5 {
        for nu in 0..5 {
            mixed.stiffness[mu][nu] =
                (0..25).map(|k| mix(mu, k / 5) * body.stiffness[k / 5][k % 5] * mix(nu, k % 5)).sum();
        }
    }
    let found = mixed.highest_frequency().unwrap();
    // The mixture has a condition of 1e4, squared in the matrices.
    assert!((found / expected - 1.0).abs() < 1e-8, "{found}, expected {expected}");
}

#[test]
fn without_stiffness_and_damping_every_step_is_stable() {
    for body in [sample::body(0), oscillator(3.0, 1.0, 0.0, 0.0)] {
        assert_eq!(body.highest_frequency(), Some(0.0));
        assert_eq!(body.largest_stable_step(), Some(f64::INFINITY));
    }
    let mut nonsense = sample::body(2);
    nonsense.inertia.mass = -1.0;
    assert_eq!(nonsense.largest_stable_step(), None);
    nonsense.inertia.mass = f64::NAN;
    assert_eq!(nonsense.largest_stable_step(), None);
}

/// Growth of the relative displacement over many steps of the classical Runge-Kutta method.
fn growth(body: &ReducedBody, step: f64) -> f64 {
    let Inertia { mass, .. } = body.inertia;
    let moment = body.inertia.modal_first_moment[0][0];
    let reduced = body.inertia.modal_mass()[0][0] - moment * moment / mass;
    let (stiffness, damping) = (body.stiffness[0][0] / reduced, body.damping[0][0] / reduced);
    let rate = |[q, p]: [f64; 2]| [p, -stiffness * q - damping * p];
    let (mut state, mut largest) = ([1.0, 0.0], 0.0_f64);
    for _ in 0..4000 {
        let along = |[q, p]: [f64; 2], [a, b]: [f64; 2], h: f64| [q + h * a, p + h * b];
        let first = rate(state);
        let second = rate(along(state, first, 0.5 * step));
        let third = rate(along(state, second, 0.5 * step));
        let fourth = rate(along(state, third, step));
        let mean = [0, 1].map(|i| (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0);
        state = along(state, mean, step);
        largest = largest.max(state[0].abs());
        if largest > 1e6 {
            break;
        }
    }
    largest
}

#[test]
fn the_step_is_stable_and_a_longer_one_is_not() {
    // Damping ratios of the oscillator of frequency 4: D = 2 ζ ω μ with the reduced mass 0.75.
    for ratio in [0.0, 0.01, 0.1, 0.25, 0.3, 0.5, 0.55, 0.7, 0.9, 1.0, 2.0, 30.0] {
        let body = oscillator(3.0, 1.0, 12.0, 6.0 * ratio);
        let step = body.largest_stable_step().unwrap();
        assert!(growth(&body, step) < 1.5, "{ratio}: {}", growth(&body, step));
        // 2.96 is the largest radius of any damping ratio; above 0.55 the bound by the damping alone can be half of it.
        let factor = if ratio < 0.56 { 2.97 / 2.61 } else { 2.3 };
        assert!(growth(&body, factor * step) > 1e6, "{ratio}");
    }
}
