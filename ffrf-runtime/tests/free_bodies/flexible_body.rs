//! A flexible body in free flight: momentum and energy are kept, at the order of the method.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use approx::assert_relative_eq;
use ffrf_runtime::nalgebra::{UnitQuaternion, Vector2, Vector3};
use ffrf_runtime::{FreeBody, Gravity, Observables, State};
use ffrf_test_kit::bodies::cloud;
use ffrf_test_kit::convergence::measured_order;
use ffrf_test_kit::naive_body::NaiveBody;
use ffrf_test_kit::tolerances::{CONSERVED_BY_RK4, ROUND_OFF, SLOPE};

type Body = FreeBody<NaiveBody<2, 8>>;

fn flying(damping: f64) -> Body {
    FreeBody::new(cloud::<2, 8>(7, 40.0, damping).0)
        .with_position(Vector3::new(0.4, -0.1, 0.2))
        .with_orientation(UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.8, 0.5)))
        .with_velocity(Vector3::new(0.5, -0.4, 0.2))
        .with_spin(Vector3::new(1.0, 2.0, -0.5))
        .with_deformation(Vector2::new(0.2, -0.1), Vector2::new(0.3, 0.5))
}

fn after(mut body: Body, duration: f64, steps: usize, implicit: bool) -> Body {
    let step = duration / steps as f64;
    for _ in 0..steps {
        if implicit {
            body.step_linearly_implicit(step, &()).unwrap();
        } else {
            body.step_rk4(step, &()).unwrap();
        }
    }
    body
}

fn energy(body: &Body) -> f64 {
    body.kinetic_energy() + body.elastic_energy()
}

/// Changes of energy, linear and angular momentum.
fn drifts(before: &Body, after: &Body) -> [f64; 3] {
    [
        (energy(after) - energy(before)).abs(),
        (after.linear_momentum() - before.linear_momentum()).norm(),
        (after.angular_momentum() - before.angular_momentum()).norm(),
    ]
}

fn distance(one: &State<Vector2<f64>>, other: &State<Vector2<f64>>) -> f64 {
    (one.position - other.position).norm()
        + one.orientation.angle_to(&other.orientation)
        + (one.modal_coordinates - other.modal_coordinates).norm()
        + (one.velocity - other.velocity).norm()
        + (one.angular_velocity - other.angular_velocity).norm()
        + (one.modal_rates - other.modal_rates).norm()
}

#[test]
fn small_steps_keep_energy_and_momentum() {
    let start = flying(0.0);
    let end = after(start, 2.0, 4_000, false);
    for drift in drifts(&start, &end) {
        assert!(drift < CONSERVED_BY_RK4 * energy(&start), "{drift}");
    }
    // the deformation must have been exercised for this to mean anything
    assert!(distance(&start.state, &end.state) > 1.0);
}

#[test]
fn drifts_fall_with_the_order_of_the_method() {
    let start = flying(0.0);
    // the sum: single drifts pass through zero now and then and then have no clean slope
    let total = |steps, implicit| drifts(&start, &after(start, 1.0, steps, implicit)).iter().sum::<f64>();
    let explicit = measured_order(160, 3, |steps| total(steps, false));
    assert!(explicit > 4.0 - SLOPE, "{explicit}");
    let implicit = measured_order(800, 3, |steps| total(steps, true));
    assert!(implicit > 2.0 - SLOPE, "{implicit}");
}

#[test]
fn orders_of_convergence_are_four_and_two() {
    for damping in [0.0, 0.5] {
        let start = flying(damping);
        let fine = after(start, 0.5, 8_000, false).state;
        let error = |steps, implicit| distance(&after(start, 0.5, steps, implicit).state, &fine);
        let explicit = measured_order(40, 3, |steps| error(steps, false));
        assert!((explicit - 4.0).abs() < SLOPE, "{explicit}");
        let implicit = measured_order(400, 3, |steps| error(steps, true));
        assert!((implicit - 2.0).abs() < SLOPE, "{implicit}");
    }
}

#[test]
fn damping_takes_energy_and_leaves_momentum() {
    let start = flying(0.5);
    let end = after(start, 2.0, 4_000, false);
    let [lost, linear, angular] = drifts(&start, &end);
    assert!(energy(&end) < energy(&start) && lost > 1e-2 * energy(&start), "{lost}");
    assert!(linear < CONSERVED_BY_RK4 * energy(&start) && angular < CONSERVED_BY_RK4 * energy(&start));
}

#[test]
fn the_centre_of_mass_falls_freely_while_the_body_tumbles() {
    let gravity = Gravity { acceleration: Vector3::new(0.0, 0.5, -9.81) };
    let mut body = flying(0.0);
    let (start, mass) = (body.centre_of_mass(), body.body.mass());
    let velocity = body.linear_momentum() / mass;
    let total = energy(&body) + body.potential_energy(&gravity.acceleration);
    for _ in 0..2_000 {
        body.step_rk4(5e-4, &gravity).unwrap();
    }
    let expected = start + velocity * body.time + gravity.acceleration * (0.5 * body.time * body.time);
    assert!((body.centre_of_mass() - expected).norm() < CONSERVED_BY_RK4);
    let now = energy(&body) + body.potential_energy(&gravity.acceleration);
    assert_relative_eq!(now, total, max_relative = CONSERVED_BY_RK4);
}

#[test]
fn both_methods_agree_where_both_resolve_the_motion() {
    let start = flying(0.2);
    let explicit = after(start, 0.2, 1_000, false).state;
    let implicit = after(start, 0.2, 16_000, true).state;
    // second order: the difference at 16 000 steps is 16² below the one at 1 000
    let coarse = distance(&after(start, 0.2, 1_000, true).state, &explicit);
    let ratio = coarse / distance(&implicit, &explicit);
    assert!((ratio / 256.0 - 1.0).abs() < SLOPE, "{ratio}");
    assert!(coarse > ROUND_OFF);
}
