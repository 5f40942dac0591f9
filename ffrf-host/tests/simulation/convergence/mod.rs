//! The order of convergence of every integrator on a flexible, constrained mechanism: places, velocities, reactions.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod conservation;
pub mod problem;

use std::sync::OnceLock;

use ffrf_host::HostMechanism;
use ffrf_host::mechanism::JointCoordinates;
use ffrf_runtime::mechanism::{Constrained, Treatment};
use ffrf_runtime::{
    EnergyMomentum, GeneralisedAlpha, RadauIIA, Tolerances, step_dormand_prince, step_linearly_implicit,
    step_linearly_implicit_euler, step_rk4, step_symplectic_euler,
};
use problem::{Blocks, DURATION, PROJECTION, SLOPE, States, blocks, differences, double_pendulum, run};

/// The end by steps of order five that make its error negligible: below 1e-12 by its own convergence.
fn reference() -> &'static Blocks {
    static REFERENCE: OnceLock<Blocks> = OnceLock::new();
    REFERENCE.get_or_init(|| {
        let (mechanism, state) = double_pendulum(PROJECTION, true);
        let system = Constrained(&mechanism);
        run(&mechanism, state, 1600, &mut |state, time, h| step_dormand_prince(&system, state, time, h))
    })
}

/// Measures the orders of all three blocks for step numbers that double, and compares the last with `expected`.
fn assert_orders(
    name: &str,
    treatment: Treatment<f64>,
    [first, doublings]: [usize; 2],
    expected: [f64; 3],
    end: impl Fn(&HostMechanism, States, usize) -> Blocks,
) {
    let reference = reference();
    let errors: Vec<[f64; 3]> = (0..=doublings)
        .map(|k| {
            let (mechanism, state) = double_pendulum(treatment, true);
            differences(&end(&mechanism, state, first << k), reference)
        })
        .collect();
    for (block, what) in ["places", "velocities", "reactions"].into_iter().enumerate() {
        let slopes: Vec<f64> =
            errors.windows(2).map(|pair| (pair[0][block] / pair[1][block]).log2()).collect();
        let found = slopes[slopes.len() - 1];
        let list: Vec<String> = errors.iter().map(|error| format!("{:.2e}", error[block])).collect();
        eprintln!("{name}, {what}: errors {list:?}, orders {slopes:.2?}");
        assert!((found - expected[block]).abs() < SLOPE, "{name}, {what}: {slopes:?}");
    }
}

fn alpha(mechanism: &HostMechanism, state: States, steps: usize, spectral_radius: f64) -> Blocks {
    let tolerances = Tolerances { relative: 1e-13, absolute: 1e-14 };
    let method = GeneralisedAlpha { spectral_radius, iterations: 30, tolerances };
    let system = Constrained(mechanism);
    let mut memory = method.start(&system, &state, 0.0, DURATION / steps as f64).unwrap();
    run(mechanism, state, steps, &mut |state, time, h| method.step(&system, &mut memory, state, time, h))
}

#[test]
fn symplectic_euler_has_order_one() {
    assert_orders("symplectic Euler", PROJECTION, [400, 2], [1.0; 3], |mechanism, state, steps| {
        let system = Constrained(mechanism);
        run(mechanism, state, steps, &mut |state, time, h| step_symplectic_euler(&system, state, time, h))
    });
}

#[test]
fn linearly_implicit_euler_has_order_one() {
    assert_orders("linearly implicit Euler", PROJECTION, [400, 2], [1.0; 3], |mechanism, state, steps| {
        let system = Constrained(mechanism);
        run(mechanism, state, steps, &mut |state, time, h| {
            step_linearly_implicit_euler(&system, state, time, h)
        })
    });
}

#[test]
fn the_linearly_implicit_method_has_order_two() {
    assert_orders("ROS2", PROJECTION, [200, 2], [2.0; 3], |mechanism, state, steps| {
        let system = Constrained(mechanism);
        run(mechanism, state, steps, &mut |state, time, h| step_linearly_implicit(&system, state, time, h))
    });
}

#[test]
fn rk4_has_order_four() {
    assert_orders("RK4", PROJECTION, [50, 2], [4.0; 3], |mechanism, state, steps| {
        let system = Constrained(mechanism);
        run(mechanism, state, steps, &mut |state, time, h| step_rk4(&system, state, time, h))
    });
}

#[test]
fn dormand_prince_has_order_five() {
    assert_orders("Dormand-Prince", PROJECTION, [100, 2], [5.0; 3], |mechanism, state, steps| {
        let system = Constrained(mechanism);
        run(mechanism, state, steps, &mut |state, time, h| step_dormand_prince(&system, state, time, h))
    });
}

#[test]
fn generalised_alpha_has_order_two_with_index_three() {
    for radius in [1.0, 0.8, 0.0] {
        let name = format!("generalised-α {radius}, index 3");
        assert_orders(&name, Treatment::Index3, [200, 2], [2.0; 3], |mechanism, state, steps| {
            alpha(mechanism, state, steps, radius)
        });
    }
}

#[test]
fn generalised_alpha_has_order_two_with_stabilised_index_two() {
    let treatment = Treatment::StabilisedIndex2;
    assert_orders("generalised-α, GGL", treatment, [200, 2], [2.0; 3], |mechanism, state, steps| {
        alpha(mechanism, state, steps, 0.8)
    });
}

#[test]
fn generalised_alpha_has_order_two_with_projection() {
    assert_orders("generalised-α, projection", PROJECTION, [200, 2], [2.0; 3], |mechanism, state, steps| {
        alpha(mechanism, state, steps, 0.8)
    });
}

#[test]
fn baumgartes_method_keeps_the_order_with_fixed_gains_alone() {
    let baumgarte = |gain: f64| Treatment::Baumgarte { alpha: gain, beta: gain };
    assert_orders("RK4, gains 20/s", baumgarte(20.0), [50, 2], [4.0; 3], |mechanism, state, steps| {
        let system = Constrained(mechanism);
        run(mechanism, state, steps, &mut |state, time, h| step_rk4(&system, state, time, h))
    });
    // stages are off the constraints by h², and gains of the order 1/h make an acceleration of order one of that
    assert_orders("RK4, gains 0.5/h", baumgarte(0.0), [200, 2], [2.0, 1.0, 0.0], |_, state, steps| {
        let (mechanism, _) = double_pendulum(baumgarte(0.5 * steps as f64 / DURATION), true);
        let system = Constrained(&mechanism);
        run(&mechanism, state, steps, &mut |state, time, h| step_rk4(&system, state, time, h))
    });
}

#[test]
fn radau_methods_have_orders_five_and_seven() {
    let tolerances = Tolerances { relative: 1e-14, absolute: 1e-15 };
    assert_orders("Radau IIA, 3 stages", PROJECTION, [20, 2], [5.0; 3], |mechanism, state, steps| {
        let system = Constrained(mechanism);
        let method = RadauIIA { tolerances, iterations: 40, ..RadauIIA::order_five() };
        run(mechanism, state, steps, &mut |state, time, h| method.step(&system, state, time, h))
    });
    assert_orders("Radau IIA, 4 stages", PROJECTION, [10, 2], [7.0; 3], |mechanism, state, steps| {
        let system = Constrained(mechanism);
        let method = RadauIIA { tolerances, iterations: 40, ..RadauIIA::order_seven() };
        run(mechanism, state, steps, &mut |state, time, h| method.step(&system, state, time, h))
    });
}

#[test]
fn the_energy_momentum_method_has_order_two() {
    assert_orders("energy-momentum", Treatment::Index3, [200, 2], [2.0; 3], |mechanism, state, steps| {
        let system = Constrained(mechanism);
        let method = EnergyMomentum::new();
        run(mechanism, state, steps, &mut |state, time, h| method.step(&system, state, time, h))
    });
}

#[test]
fn joint_coordinates_keep_the_order_and_do_not_drift() {
    assert_orders("RK4, joint coordinates", PROJECTION, [50, 2], [4.0; 3], |mechanism, state, steps| {
        let tree = JointCoordinates::new(mechanism).unwrap();
        let h = DURATION / steps as f64;
        let mut relative = tree.relative(&state);
        // there and back is the same state
        let back = blocks(mechanism, &tree.absolute(&relative), 0.0);
        let there = differences(&back, &blocks(mechanism, &state, 0.0));
        assert!(there.iter().all(|difference| *difference < 1e-12), "{there:?}");
        for k in 0..steps {
            relative = step_rk4(&tree, &relative, k as f64 * h, h).unwrap().0;
        }
        let state = tree.absolute(&relative);
        let (_, drift) = Constrained(mechanism).project(DURATION, state.clone(), None, 0, f64::MAX).unwrap();
        assert!(drift.position < 1e-14 && drift.velocity < 1e-13, "{drift:?}");
        blocks(mechanism, &state, DURATION)
    });
}
