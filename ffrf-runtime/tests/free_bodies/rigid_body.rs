//! A rigid body (M = 0) without load: the laws of its motion, to the accuracy of the integrators.

use approx::assert_relative_eq;
use ffrf_runtime::nalgebra::{SVector, UnitQuaternion, Vector3};
use ffrf_runtime::{FreeBody, Gravity, State};
use ffrf_test_kit::bodies::rigid;
use ffrf_test_kit::convergence::measured_order;
use ffrf_test_kit::naive_body::NaiveBody;
use ffrf_test_kit::tolerances::{CONSERVED_BY_RK4, ROUND_OFF, SLOPE};

fn tumbling() -> FreeBody<NaiveBody<0, 6>> {
    FreeBody::new(rigid(2.0, Vector3::new(1.0, 2.0, 2.5)))
        .with_position(Vector3::new(0.1, 0.2, -0.3))
        .with_velocity(Vector3::new(0.5, -0.4, 0.2))
        .with_spin(Vector3::new(0.02, 3.0, 0.1))
}

#[test]
fn energy_and_momentum_stay_over_many_flips() {
    let mut body = tumbling();
    let (energy, angular, linear) = (body.kinetic_energy(), body.angular_momentum(), body.linear_momentum());
    for _ in 0..10_000 {
        body.step_rk4(1e-3, &()).unwrap();
    }
    assert_relative_eq!(body.kinetic_energy(), energy, max_relative = CONSERVED_BY_RK4);
    assert!((body.angular_momentum() - angular).norm() < CONSERVED_BY_RK4 * angular.norm());
    assert!((body.linear_momentum() - linear).norm() < ROUND_OFF);
    assert_relative_eq!(body.time, 10.0, max_relative = ROUND_OFF);
}

#[test]
fn spin_about_a_symmetry_axis_is_the_closed_form() {
    // symmetric top, torque-free: ω precesses in the body about z at (I3 - I1) / I1 ω3
    let (side, axis, spin) = (1.0, 1.5, 4.0);
    let mut body =
        FreeBody::new(rigid(1.0, Vector3::new(side, side, axis))).with_spin(Vector3::new(0.3, 0.0, spin));
    for _ in 0..2_000 {
        body.step_rk4(1e-3, &()).unwrap();
    }
    let phase = (axis - side) / side * spin * body.time;
    let expected = Vector3::new(0.3 * phase.cos(), 0.3 * phase.sin(), spin);
    assert!((body.state.angular_velocity - expected).norm() < CONSERVED_BY_RK4, "{:?}", body.state);
}

#[test]
fn free_fall_is_exact_and_does_not_turn() {
    let gravity = Gravity { acceleration: Vector3::new(0.3, -0.2, -9.81) };
    for implicit in [false, true] {
        let mut body = tumbling().with_spin(Vector3::zeros());
        let (start, velocity) = (body.state.position, body.state.velocity);
        let energy = body.kinetic_energy() + body.potential_energy(&gravity.acceleration);
        for _ in 0..50 {
            let step = 0.02;
            let report = if implicit {
                body.step_linearly_implicit(step, &gravity)
            } else {
                body.step_rk4(step, &gravity)
            };
            report.unwrap();
        }
        let expected = start + velocity * body.time + gravity.acceleration * (0.5 * body.time * body.time);
        assert!((body.state.position - expected).norm() < ROUND_OFF, "{implicit}: {}", body.state.position);
        assert_eq!(body.state.orientation, UnitQuaternion::identity());
        let after = body.kinetic_energy() + body.potential_energy(&gravity.acceleration);
        assert_relative_eq!(after, energy, max_relative = ROUND_OFF);
    }
}

#[test]
fn the_orientation_stays_a_unit_quaternion_however_long_and_fast_the_body_turns() {
    for implicit in [false, true] {
        // half a radian a step about a principal axis, eight thousand turns
        let mut body = tumbling()
            .with_orientation(UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.8, 0.5)))
            .with_spin(Vector3::new(0.0, 50.0, 0.0));
        for _ in 0..100_000 {
            let report =
                if implicit { body.step_linearly_implicit(0.01, &()) } else { body.step_rk4(0.01, &()) };
            report.unwrap();
        }
        let excess = body.state.orientation.norm() - 1.0;
        assert!(excess.abs() < ROUND_OFF, "{excess:e}");
    }
}

#[test]
fn a_fast_rotation_about_a_principal_axis_is_followed_at_the_order_of_the_method() {
    // ω stays as it is, so that all of the error is that of the chart of rotations; exact: the angle is ω t
    let spin = Vector3::new(0.0, 0.0, 200.0);
    let error = |steps: usize, implicit: bool| {
        let mut body = FreeBody::new(rigid(1.0, Vector3::new(1.0, 1.2, 2.0))).with_spin(spin);
        let step = 0.1 / steps as f64;
        for _ in 0..steps {
            let report =
                if implicit { body.step_linearly_implicit(step, &()) } else { body.step_rk4(step, &()) };
            report.unwrap();
        }
        let exact = UnitQuaternion::from_scaled_axis(spin * body.time);
        body.state.orientation.angle_to(&exact)
    };
    // from one radian a step to an eighth of one, and from a quarter of one to a thirty-second part
    let explicit = measured_order(20, 3, |steps| error(steps, false));
    assert!((explicit - 4.0).abs() < SLOPE, "{explicit}");
    let implicit = measured_order(80, 3, |steps| error(steps, true));
    assert!((implicit - 2.0).abs() < SLOPE, "{implicit}");
}

#[test]
fn orders_of_convergence_are_four_and_two() {
    let run = |steps: usize, implicit: bool| -> State<SVector<f64, 0>> {
        let mut body = tumbling();
        let step = 1.0 / steps as f64;
        for _ in 0..steps {
            if implicit {
                body.step_linearly_implicit(step, &()).unwrap();
            } else {
                body.step_rk4(step, &()).unwrap();
            }
        }
        body.state
    };
    let fine = run(4_000, false);
    let error = |state: &State<SVector<f64, 0>>| {
        (state.angular_velocity - fine.angular_velocity).norm()
            + state.orientation.angle_to(&fine.orientation)
    };
    let explicit = measured_order(20, 4, |steps| error(&run(steps, false)));
    assert!((explicit - 4.0).abs() < SLOPE, "{explicit}");
    let implicit = measured_order(100, 4, |steps| error(&run(steps, true)));
    assert!((implicit - 2.0).abs() < SLOPE, "{implicit}");
}
