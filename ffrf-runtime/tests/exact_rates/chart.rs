//! The chart that integrators work in: its rates are the exact derivatives of the state that it leads to.

use super::motions::{Prescribed, parts, wave};
use ffrf_runtime::nalgebra::{Quaternion, SVector, UnitQuaternion, Vector3};
use ffrf_runtime::rotation::{cayley, cayley_omega, cayley_rate, turned};
use ffrf_runtime::{Increment, Motion, State};
use ffrf_test_kit::tolerances::{DERIVED, ROUND_OFF};
use num_dual::{Dual, Dual64};

type Modal = SVector<f64, 3>;
type DualModal = SVector<Dual64, 3>;

fn dual_state(state: &State<Modal>) -> State<DualModal, Dual64> {
    let number = |x: f64| Dual::from(x);
    State {
        position: state.position.map(number),
        orientation: UnitQuaternion::new_unchecked(Quaternion::from(state.orientation.coords.map(number))),
        modal_coordinates: state.modal_coordinates.map(number),
        velocity: state.velocity.map(number),
        angular_velocity: state.angular_velocity.map(number),
        modal_rates: state.modal_rates.map(number),
    }
}

/// Increments as functions of time, of order one: turns of up to two radians.
fn increment(seed: usize, time: f64) -> Increment<DualModal, Dual64> {
    let time = Dual64::new(time, 1.0);
    let part = |start: usize| Vector3::from_fn(|k, _| wave(start + k + 31 * seed, time));
    Increment {
        position: part(0),
        rotation: part(3),
        modal_coordinates: part(6),
        velocity: part(9),
        angular_velocity: part(12),
        modal_rates: part(15),
    }
}

fn close(found: &Vector3<f64>, expected: &Vector3<f64>) {
    assert!((found - expected).norm() < DERIVED * expected.norm().max(1.0), "{found} {expected}");
}

fn values(vector: &Vector3<Dual64>) -> Vector3<f64> {
    vector.map(|x| x.re)
}

fn rates(vector: &Vector3<Dual64>) -> Vector3<f64> {
    vector.map(|x| x.eps)
}

#[test]
fn the_rate_of_an_increment_leads_along_the_motion() {
    for seed in 1..20 {
        for time in [0.0, 0.5, 1.1] {
            let origin = Prescribed::<3>::at(seed, 0.2).state;
            let path = increment(seed, time);
            let exact = dual_state(&origin).retract(&path);
            let plain = Increment {
                position: values(&path.position),
                rotation: values(&path.rotation),
                modal_coordinates: values(&path.modal_coordinates),
                velocity: values(&path.velocity),
                angular_velocity: values(&path.angular_velocity),
                modal_rates: values(&path.modal_rates),
            };
            let mut state = origin.retract(&plain);
            assert!(
                (state.orientation.quaternion() - parts(&exact.orientation, |x| x.re)).norm() < ROUND_OFF
            );
            // the velocities with which the state follows its path
            let turning = parts(&exact.orientation, |x| x.eps);
            state.velocity = rates(&exact.position);
            state.angular_velocity = (state.orientation.quaternion().conjugate() * turning).imag() * 2.0;
            state.modal_rates = rates(&exact.modal_coordinates);
            assert!(state.angular_velocity.norm() > 0.05);
            let accelerations = Motion {
                linear: state.to_body(&rates(&exact.velocity)),
                angular: rates(&exact.angular_velocity),
                modal: rates(&exact.modal_rates),
            };
            let found = plain.rate(&state, accelerations);
            close(&found.position, &rates(&path.position));
            close(&found.rotation, &rates(&path.rotation));
            close(&found.modal_coordinates, &rates(&path.modal_coordinates));
            close(&found.velocity, &rates(&path.velocity));
            close(&found.angular_velocity, &rates(&path.angular_velocity));
            close(&found.modal_rates, &rates(&path.modal_rates));
        }
    }
}

#[test]
fn the_map_turns_by_twice_the_arc_tangent_of_half_its_vector() {
    for angle in [1e-8, 0.1, 1.0, 3.0, 100.0] {
        let axis = Vector3::new(0.48, -0.6, 0.64);
        let found = cayley(&(axis * angle));
        let expected = UnitQuaternion::from_scaled_axis(axis * (2.0 * (0.5_f64 * angle).atan()));
        assert!((found.quaternion() - expected.quaternion()).norm() < ROUND_OFF, "{angle}");
        assert!((found.norm() - 1.0).abs() < ROUND_OFF);
        // nothing but the axis itself turns along it
        let rate = cayley_rate(&(axis * angle), &axis);
        assert!((rate - axis * (1.0 + 0.25 * angle * angle)).norm() < ROUND_OFF * (1.0 + angle * angle));
    }
    assert_eq!(cayley(&Vector3::<f64>::zeros()), UnitQuaternion::identity());
}

#[test]
fn the_angular_velocity_of_a_rate_is_the_one_that_gave_it() {
    for seed in 0..20 {
        let part = |start: usize| Vector3::from_fn(|k, _| 2.0 * wave::<f64>(start + k + 31 * seed, 0.3));
        let (rotation, omega) = (part(0), part(3));
        close(&cayley_omega(&rotation, &cayley_rate(&rotation, &omega)), &omega);
    }
}

#[test]
fn a_turn_follows_the_orientation_and_mends_its_norm() {
    let start = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.8, 0.5));
    let turn = Vector3::new(0.2, 0.4, -0.9);
    let expected = start * cayley(&turn);
    assert!((turned(&start, &turn).quaternion() - expected.quaternion()).norm() < ROUND_OFF);
    let worn = UnitQuaternion::new_unchecked(start.quaternion() * (1.0 + 1e-6));
    assert!((turned(&worn, &turn).norm() - 1.0).abs() < ROUND_OFF);
}
