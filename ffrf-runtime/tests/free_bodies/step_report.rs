//! What a step reports: error estimates that overstate the true error and shrink with their own order.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf_runtime::nalgebra::{Vector2, Vector3};
use ffrf_runtime::{
    Departure, Drift, EnergyMomentum, Envelope, FreeBody, FreeSystem, LocalError, State, StepReport, Watched,
    step_dormand_prince, step_linearly_implicit, step_rk4,
};
use ffrf_test_kit::bodies::cloud;
use ffrf_test_kit::convergence::measured_order;
use ffrf_test_kit::naive_body::NaiveBody;
use ffrf_test_kit::tolerances::{ROUND_OFF, SLOPE};

type Body = FreeBody<NaiveBody<2, 8>>;

fn flying() -> Body {
    FreeBody::new(cloud::<2, 8>(7, 40.0, 0.2).0)
        .with_velocity(Vector3::new(0.5, -0.4, 0.2))
        .with_spin(Vector3::new(1.0, 2.0, -0.5))
        .with_deformation(Vector2::new(0.2, -0.1), Vector2::new(0.3, 0.5))
}

fn one_step(step: f64, implicit: bool) -> (Body, StepReport) {
    let mut body = flying();
    let report = if implicit { body.step_linearly_implicit(step, &()) } else { body.step_rk4(step, &()) };
    (body, report.unwrap())
}

fn true_error(step: f64, body: &Body) -> LocalError {
    let mut exact = flying();
    for _ in 0..100 {
        exact.step_rk4(step / 100.0, &()).unwrap();
    }
    LocalError {
        position: (body.state.position - exact.state.position).amax(),
        orientation: body.state.orientation.angle_to(&exact.state.orientation),
        modal_coordinates: (body.state.modal_coordinates - exact.state.modal_coordinates).amax(),
    }
}

#[test]
fn estimates_overstate_the_error_of_the_step() {
    for (implicit, step) in [(false, 0.02), (true, 0.005)] {
        let (body, report) = one_step(step, implicit);
        let (estimate, error) = (report.local_error, true_error(step, &body));
        assert!(estimate.position > error.position, "{estimate:?} {error:?}");
        assert!(estimate.orientation > error.orientation, "{estimate:?} {error:?}");
        assert!(estimate.modal_coordinates > error.modal_coordinates, "{estimate:?} {error:?}");
    }
}

#[test]
fn estimates_have_the_order_of_the_embedded_method() {
    // one step with a method of order p makes an error of order p + 1; embedded are p = 2 and p = 1
    for (implicit, expected) in [(false, 3.0), (true, 2.0)] {
        let order = measured_order(50, 4, |steps| {
            one_step(1.0 / steps as f64, implicit).1.local_error.modal_coordinates
        });
        assert!((order - expected).abs() < SLOPE, "{order}");
    }
}

#[test]
fn a_free_body_has_no_constraints_to_drift_from() {
    for implicit in [false, true] {
        let (body, report) = one_step(0.1, implicit);
        assert_eq!(report.drift, Drift::none());
        // a step of a tenth of a second turns by 0.23 rad, and the orientation is still one
        assert!((body.state.orientation.norm() - 1.0).abs() < ROUND_OFF);
    }
}

/// Wider than the motion of [`flying`], but for what `change` changes.
fn envelope(change: impl Fn(&mut Envelope)) -> Envelope {
    let mut envelope = Envelope { deformation: 1.0, speed: 2.0, spin: 5.0, bending: 50.0 };
    change(&mut envelope);
    envelope
}

#[test]
fn a_watched_step_is_the_step_itself_and_says_which_bound_was_left() {
    let body = flying();
    let system = FreeSystem { body: &body.body, load: &() };
    let (plain, unseen) = step_rk4(&system, &body.state, 0.0, 0.01).unwrap();
    assert!(!unseen.departure.any(), "nobody looks");
    let none = Departure::default();
    let cases = [
        (envelope(|_| ()), none),
        (envelope(|envelope| envelope.deformation = 0.1), Departure { deformation: true, ..none }),
        (envelope(|envelope| envelope.speed = 0.1), Departure { speed: true, ..none }),
        (envelope(|envelope| envelope.spin = 1.0), Departure { spin: true, ..none }),
        (envelope(|envelope| envelope.bending = 2.0), Departure { bending: true, ..none }),
        (envelope(|envelope| envelope.speed = f64::NAN), Departure { speed: true, ..none }),
    ];
    for (envelope, expected) in cases {
        let look = |state: &State<Vector2<f64>>| envelope.departure(state);
        let watched = Watched { system: &system, look };
        let (state, report) = step_rk4(&watched, &body.state, 0.0, 0.01).unwrap();
        assert_eq!(report.departure, expected, "{envelope:?}");
        assert_eq!(state, plain, "looking changes nothing");
        assert_eq!(StepReport { departure: none, ..report }, unseen);
        // methods that take the modes implicitly, one that iterates, one with error control
        let implicit = step_linearly_implicit(&watched, &body.state, 0.0, 0.01).unwrap();
        assert_eq!(implicit.1.departure, expected, "{envelope:?}");
        assert_eq!(implicit.0, step_linearly_implicit(&system, &body.state, 0.0, 0.01).unwrap().0);
        let conserving = EnergyMomentum::new().step(&watched, &body.state, 0.0, 0.01).unwrap();
        assert_eq!(conserving.1.departure, expected, "{envelope:?}");
        let controlled = step_dormand_prince(&watched, &body.state, 0.0, 0.01).unwrap();
        assert_eq!(controlled.1.departure, expected, "{envelope:?}");
    }
}

/// A body that is pushed leaves the envelope in one step, and every step from there on says so.
#[test]
fn the_flag_goes_up_when_the_bound_is_passed_and_not_before() {
    let body = flying();
    let system = FreeSystem { body: &body.body, load: &() };
    // the deformation oscillates: a bound in the middle of its range is left and met again
    let (mut state, mut least, mut most) = (body.state, f64::INFINITY, 0.0_f64);
    for _ in 0..400 {
        state = step_rk4(&system, &state, 0.0, 0.01).unwrap().0;
        let norm = state.modal_coordinates.norm();
        (least, most) = (least.min(norm), most.max(norm));
    }
    let bound = 0.5 * (least + most);
    let watched = Watched {
        system: &system,
        look: |state: &State<Vector2<f64>>| envelope(|e| e.deformation = bound).departure(state),
    };
    let (mut state, mut seen) = (body.state, [0; 2]);
    for _ in 0..400 {
        let (next, report) = step_rk4(&watched, &state, 0.0, 0.01).unwrap();
        state = next;
        assert_eq!(report.departure.deformation, state.modal_coordinates.norm() > bound);
        seen[usize::from(report.departure.deformation)] += 1;
    }
    assert!(seen[0] > 10 && seen[1] > 10, "both happen: {seen:?}");
}
