//! The kernels that the command runs without compiling generated code: loops over tables against expressions.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf_codegen::{GenerateOptions, Kernels, Strategy};
use ffrf_host::kernels::GeneratedKernels;
use ffrf_model::ReducedBody;
use ffrf_test_kit::random::Random;
use ffrf_test_kit::random_body::{Modes, random_body};

/// Rounding of sums over all pairs of 64 modes, relative to the largest entry; far above what was found.
const ROUNDING: f64 = 1e-13;

fn compare(what: &str, modes: usize, found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{what}, M = {modes}");
    let scale = expected.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        let deviation = (found - expected).abs();
        assert!(deviation <= ROUNDING * scale, "{what}, M = {modes}, {index}: {found} for {expected}");
    }
}

/// Every kernel that is a loop, in the loops and in the expressions.
fn agree(body: &ReducedBody, options: &GenerateOptions, form: &str) {
    let modes = body.mode_count();
    let found = GeneratedKernels::new(body, options).unwrap();
    assert!(found.description().contains(form), "M = {modes}: {}", found.description());
    let expected = Kernels::formulate(body, options).unwrap();
    let mut random = Random::new(7);
    let (q, q_dot) = (random.numbers(modes), random.numbers(modes));
    let (velocity, omega) = (random.vector(), random.vector());
    let q: Vec<f64> = q.iter().map(|q| 0.05 * q).collect();
    let force = random.numbers(6 + modes);
    let mass = expected.mass_matrix(&q).concat();
    compare("mass matrix", modes, &found.mass_matrix(&q).concat(), &mass);
    let quadratic = expected.quadratic_velocity(&q, &omega, &q_dot);
    compare("quadratic velocity", modes, &found.quadratic_velocity(&q, &omega, &q_dot), &quadratic);
    let accelerations = expected.forward_dynamics(&q, &omega, &q_dot, &force);
    compare("accelerations", modes, &found.forward_dynamics(&q, &omega, &q_dot, &force), &accelerations);
    let energy = expected.kinetic_energy(&q, &velocity, &omega, &q_dot);
    compare("energy", modes, &[found.kinetic_energy(&q, &velocity, &omega, &q_dot)], &[energy]);
    let momentum = expected.angular_momentum(&q, &velocity, &omega, &q_dot);
    compare("momentum", modes, &found.angular_momentum(&q, &velocity, &omega, &q_dot), &momentum);
}

#[test]
fn loops_over_tables_compute_what_the_expressions_say() {
    // The layout tolerance covers the rounding of the orthonormalisation.
    let options = GenerateOptions { layout_tolerance: 1e-12, ..GenerateOptions::default() };
    for modes in [7, 8, 9, 13, 19, 20, 22, 33, 64] {
        // The stiffness of these bodies is dense: K q is taken from the force before the loops.
        agree(&random_body(3, modes, Modes::Normalised), &options, "lanes over modes");
    }
    for modes in [7, 21] {
        let mut body = random_body(4, modes, Modes::FreeFree);
        for (mu, row) in body.stiffness.iter_mut().enumerate() {
            row.iter_mut().enumerate().for_each(|(nu, k)| *k = if mu == nu { 40.0 } else { 0.0 });
        }
        body.damping.clone_from(&body.stiffness);
        agree(&body, &options, "lanes over modes");
    }
    let lanes = GenerateOptions { strategy: Strategy::Lanes, ..options.clone() };
    for modes in [1, 3, 5] {
        agree(&random_body(5, modes, Modes::Normalised), &lanes, "lanes over modes");
    }
    let constant = GenerateOptions { fidelity: ffrf_codegen::Fidelity::Constant, ..options };
    for modes in [10, 24] {
        agree(&random_body(6, modes, Modes::Normalised), &constant, "no moments");
    }
}

#[test]
fn few_modes_and_very_many_are_interpreted_and_say_so() {
    let options = GenerateOptions { layout_tolerance: 1e-12, ..GenerateOptions::default() };
    agree(&random_body(3, 2, Modes::Normalised), &options, "straight-line");
    let body = random_body(3, 65, Modes::Normalised);
    let kernels = GeneratedKernels::new(&body, &options).unwrap();
    assert!(kernels.description().contains("more than 64 modes"), "{}", kernels.description());
}
