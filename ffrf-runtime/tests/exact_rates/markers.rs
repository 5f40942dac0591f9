//! Markers are exact to each other: velocities are the derivatives of places, biases what is left of the second
//! derivatives, forces the transpose of velocities. By dual numbers, for deformations and rotations of any size.

use super::motions::{Prescribed, parts};
use ffrf_runtime::nalgebra::{Quaternion, SMatrix, SVector, UnitQuaternion, Vector3};
use ffrf_runtime::{GeneralisedForce, Marker, MarkerMotion, Motion, PlacedMarker, State, Wrench};
use ffrf_test_kit::bodies::cloud;
use ffrf_test_kit::tolerances::{DERIVED, ROUND_OFF};
use num_dual::{Dual, Dual2_64, Dual64};

type Modal = SVector<f64, 3>;

/// Every marker of a cloud in motions of every kind.
fn for_every_marker(mut check: impl FnMut(&Marker<Modal>, &Prescribed<3>)) {
    for seed in 1..10 {
        for marker in &cloud::<3, 9>(seed, 30.0, 0.0).1 {
            for time in [0.0, 0.4, 1.3] {
                check(marker, &Prescribed::at(seed as usize, time));
            }
        }
    }
}

fn close(found: &Vector3<f64>, expected: &Vector3<f64>) {
    assert!((found - expected).norm() < DERIVED * expected.norm().max(1.0), "{found} {expected}");
}

/// 2 θ' ⊗ θ*, the inertial components of a rate of rotation of first or second order.
fn turning(orientation: &UnitQuaternion<f64>, derivative: &Quaternion<f64>) -> Vector3<f64> {
    (derivative * orientation.quaternion().conjugate()).imag() * 2.0
}

/// The place of the marker as a function of time.
fn dual_motion(marker: &Marker<Modal>, motion: &Prescribed<3>) -> MarkerMotion<Dual2_64> {
    let marker = marker.cast::<Dual2_64>();
    PlacedMarker::new(&marker, &motion.place).motion(&motion.place)
}

#[test]
fn velocities_are_the_derivatives_of_position_and_orientation() {
    for_every_marker(|marker, motion| {
        let exact = dual_motion(marker, motion);
        let found = PlacedMarker::new(marker, &motion.state).motion(&motion.state);
        close(&found.position, &exact.position.map(|x| x.re));
        close(&found.velocity, &exact.position.map(|x| x.v1));
        let difference = found.orientation.quaternion() - parts(&exact.orientation, |x| x.re);
        assert!(difference.norm() < ROUND_OFF);
        let spin = turning(&found.orientation, &parts(&exact.orientation, |x| x.v1));
        assert!(spin.norm() > 0.1);
        close(&found.angular_velocity, &spin);
        // resolved in the body frame, by the marker alone
        let State { modal_coordinates: q, angular_velocity: omega, modal_rates: q_dot, .. } = &motion.state;
        let velocity = marker.velocity(q, &motion.state.body_velocity(), omega, q_dot);
        close(&motion.state.to_inertial(&velocity), &found.velocity);
        let spin = marker.angular_velocity(q, omega, q_dot);
        close(&motion.state.to_inertial(&spin), &found.angular_velocity);
    });
}

#[test]
fn twists_with_biases_are_the_second_derivatives() {
    for_every_marker(|marker, motion| {
        let exact = dual_motion(marker, motion);
        let placed = PlacedMarker::new(marker, &motion.state);
        let found = placed.motion(&motion.state);
        let [velocity, spin] = placed.twist(&motion.state.velocities());
        close(&velocity, &found.velocity);
        close(&spin, &found.angular_velocity);
        let [linear, angular] = placed.twist(&motion.acceleration);
        close(&(linear + found.acceleration_bias), &exact.position.map(|x| x.v2));
        let expected = turning(&found.orientation, &parts(&exact.orientation, |x| x.v2));
        close(&(angular + found.angular_acceleration_bias), &expected);
        // the biases are no round-off
        assert!(found.acceleration_bias.norm() > 1e-3 && found.angular_acceleration_bias.norm() > 1e-4);
    });
}

#[test]
fn generalised_forces_are_the_transposed_twist() {
    for_every_marker(|marker, motion| {
        let placed = PlacedMarker::new(marker, &motion.state);
        let mut twists = SMatrix::<f64, 6, 9>::zeros();
        let mut forces = SMatrix::<f64, 6, 9>::zeros();
        for column in 0..9 {
            let mut unit = SVector::<f64, 9>::zeros();
            unit[column] = 1.0;
            let [linear, angular] = placed.twist(&Motion::from_vector(&unit));
            twists.fixed_view_mut::<3, 1>(0, column).copy_from(&linear);
            twists.fixed_view_mut::<3, 1>(3, column).copy_from(&angular);
        }
        for row in 0..6 {
            let mut unit = SVector::<f64, 6>::zeros();
            unit[row] = 1.0;
            let wrench = Wrench {
                force: unit.fixed_rows::<3>(0).into_owned(),
                moment: unit.fixed_rows::<3>(3).into_owned(),
            };
            let force = placed.generalised_force(&wrench).to_vector::<9>();
            forces.row_mut(row).copy_from(&force.transpose());
        }
        assert!((twists - forces).amax() < ROUND_OFF * twists.amax().max(1.0), "{twists} {forces}");

        // the same by the marker alone, and by powers
        let wrench = Wrench { force: Vector3::new(1.3, -0.4, 0.8), moment: Vector3::new(-0.2, 0.9, 0.5) };
        let found = placed.generalised_force(&wrench);
        let state = &motion.state;
        let mut expected = marker.force(&state.modal_coordinates, &state.to_body(&wrench.force));
        expected.add_scaled(1.0, &marker.moment(&state.modal_coordinates, &state.to_body(&wrench.moment)));
        let difference = found.to_vector::<9>() - expected.to_vector();
        assert!(difference.norm() < ROUND_OFF * expected.to_vector::<9>().norm());
        let seen = placed.motion(state);
        let power = wrench.power(&seen.velocity, &seen.angular_velocity);
        let scale = found.to_vector::<9>().norm() * state.velocities().to_vector::<9>().norm();
        assert!((found.power(&state.velocities()) - power).abs() < ROUND_OFF * scale);
        let _: GeneralisedForce<Modal> = found;
    });
}

/// Projections on constraints move bodies by small motions: a marker then moves by their twist.
#[test]
fn a_displacement_moves_markers_by_its_twist() {
    for_every_marker(|marker, motion| {
        let step = motion.acceleration;
        let small = Dual64::new(0.0, 1.0);
        let number = |x: f64| Dual::from(x);
        let mut moved: State<SVector<Dual64, 3>, Dual64> = State {
            position: motion.state.position.map(number),
            orientation: UnitQuaternion::new_unchecked(Quaternion::from(
                motion.state.orientation.coords.map(number),
            )),
            modal_coordinates: motion.state.modal_coordinates.map(number),
            velocity: motion.state.velocity.map(number),
            angular_velocity: motion.state.angular_velocity.map(number),
            modal_rates: motion.state.modal_rates.map(number),
        };
        moved.displace(&Motion {
            linear: step.linear.map(|x| small * x),
            angular: step.angular.map(|x| small * x),
            modal: step.modal.map(|x| small * x),
        });
        let dual_marker = marker.cast::<Dual64>();
        let exact = PlacedMarker::new(&dual_marker, &moved).motion(&moved);
        let placed = PlacedMarker::new(marker, &motion.state);
        let [linear, angular] = placed.twist(&step);
        close(&linear, &exact.position.map(|x| x.eps));
        let orientation = placed.motion(&motion.state).orientation;
        close(&angular, &turning(&orientation, &parts(&exact.orientation, |x| x.eps)));
    });
}

#[test]
fn a_rigid_marker_turns_with_the_body() {
    let motion = Prescribed::<3>::at(2, 0.7);
    let state = &motion.state;
    let marker = Marker::rigid(Vector3::new(0.3, 0.1, -0.2), &state.modal_coordinates);
    let found = PlacedMarker::new(&marker, state).motion(state);
    let arm = state.to_inertial(&marker.position);
    let omega = state.to_inertial(&state.angular_velocity);
    close(&found.position, &(state.position + arm));
    close(&found.velocity, &(state.velocity + omega.cross(&arm)));
    close(&found.angular_velocity, &omega);
    close(&found.acceleration_bias, &omega.cross(&omega.cross(&arm)));
    assert_eq!(found.orientation, state.orientation);
    assert_eq!(found.angular_acceleration_bias, Vector3::zeros());
}
