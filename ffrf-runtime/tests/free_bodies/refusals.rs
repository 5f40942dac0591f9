//! Steps that are refused: the reason is told, nothing is changed, nothing panics.

use ffrf_runtime::nalgebra::{SVector, Vector3};
use ffrf_runtime::{FreeBody, GeneralisedForce, State, StepError};
use ffrf_test_kit::bodies::{cloud, rigid};
use ffrf_test_kit::naive_body::{Invariants, NaiveBody};
use proptest::prelude::*;

type RigidState = State<SVector<f64, 0>>;
type Push = GeneralisedForce<SVector<f64, 0>>;

#[test]
fn bad_step_sizes_are_named() {
    let mut body = FreeBody::new(rigid(1.0, Vector3::new(1.0, 1.0, 1.0)));
    for found in [0.0, -0.1, f64::INFINITY] {
        assert_eq!(body.step_rk4(found, &()), Err(StepError::StepSize { found }));
        assert_eq!(body.step_linearly_implicit(found, &()), Err(StepError::StepSize { found }));
    }
    let error = body.step_rk4(f64::NAN, &()).unwrap_err();
    assert_eq!(error.to_string(), "step size: expected a positive time, found NaN s");
    assert_eq!(body.time, 0.0);
}

#[test]
fn a_broken_state_is_not_stepped() {
    let mut body = FreeBody::new(rigid(1.0, Vector3::new(1.0, 1.0, 1.0)));
    body.state.velocity.y = f64::NAN;
    assert_eq!(body.step_rk4(0.1, &()), Err(StepError::NonFiniteState));
    assert_eq!(body.step_linearly_implicit(0.1, &()), Err(StepError::NonFiniteState));
}

#[test]
fn a_broken_load_leaves_the_body_alone() {
    let bad = |_: &NaiveBody<0, 6>, _: f64, _: &RigidState, force: &mut Push| force.force.x = f64::NAN;
    let mut body = FreeBody::new(rigid(1.0, Vector3::new(1.0, 1.0, 1.0))).with_spin(Vector3::x());
    let before = body;
    assert_eq!(body.step_rk4(0.1, &bad), Err(StepError::NonFiniteAcceleration));
    assert_eq!(body.step_linearly_implicit(0.1, &bad), Err(StepError::NonFiniteAcceleration));
    assert_eq!(body, before);
}

#[test]
fn a_mass_that_is_not_positive_is_refused() {
    let unphysical = Invariants {
        mass: -1.0,
        centre_of_mass: [0.0; 3],
        modal_centre_of_mass: [],
        euler_tensor: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        modal_euler_tensor: [],
        modal_pair_euler_tensor: [],
        stiffness: [],
        damping: [],
    };
    let mut body: FreeBody<NaiveBody<0, 6>> = FreeBody::new(NaiveBody::new(&unphysical));
    assert_eq!(body.step_linearly_implicit(0.1, &()), Err(StepError::MassNotPositive));
    assert_eq!(body.step_rk4(0.1, &()), Err(StepError::MassNotPositive));
}

#[test]
fn errors_are_errors() {
    let error: Box<dyn core::error::Error> = Box::new(StepError::MassNotPositive);
    assert!(error.to_string().starts_with("the mass matrix is not positive definite"));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Any numbers at all, infinities and subnormals included: a step succeeds with a finite, normalised
    /// state, or fails and changes nothing.
    #[test]
    fn no_number_makes_a_step_panic(
        numbers in proptest::collection::vec(proptest::num::f64::ANY, 14),
        step in proptest::num::f64::ANY,
        implicit: bool,
    ) {
        let mut body = FreeBody::new(cloud::<2, 8>(3, 1e3, 1.0).0)
            .with_position(Vector3::new(numbers[0], numbers[1], numbers[2]))
            .with_velocity(Vector3::new(numbers[3], numbers[4], numbers[5]))
            .with_spin(Vector3::new(numbers[6], numbers[7], numbers[8]))
            .with_deformation(
                SVector::from([numbers[9], numbers[10]]),
                SVector::from([numbers[11], numbers[12]]),
            );
        let before = format!("{body:?}");
        let result =
            if implicit { body.step_linearly_implicit(step, &()) } else { body.step_rk4(step, &()) };
        match result {
            Ok(_) => {
                prop_assert!(body.state.is_finite());
                prop_assert!((body.state.orientation.norm() - 1.0).abs() < ffrf_test_kit::tolerances::ROUND_OFF);
            }
            Err(_) => prop_assert_eq!(format!("{body:?}"), before),
        }
    }
}
