//! Stiff modes: the linearly implicit step stays stable and accurate in the slow motion, RK4 does not.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf_runtime::nalgebra::{Vector2, Vector3};
use ffrf_runtime::{Frame, FreeBody, Gravity, MarkerLoad, StepError};
use ffrf_test_kit::bodies::cloud;
use ffrf_test_kit::convergence::measured_order;
use ffrf_test_kit::naive_body::NaiveBody;
use ffrf_test_kit::tolerances::{QUIET_STIFF_MODES, SLOPE, SLOW_MOTION_AT_LARGE_STEP};

const STIFFNESS: f64 = 1e10;

fn stiff() -> FreeBody<NaiveBody<2, 8>> {
    FreeBody::new(cloud::<2, 8>(7, STIFFNESS, 0.0).0).with_spin(Vector3::new(1.0, 2.0, -0.5))
}

/// Largest eigenfrequency of the free body: of K_ff against the Schur complement of the modes.
fn largest_frequency() -> f64 {
    use ffrf_runtime::DenseForms;
    let body = cloud::<2, 8>(7, STIFFNESS, 0.0).0;
    let inverse = body.mass_matrix(&Vector2::zeros()).try_inverse().unwrap();
    let matrix = inverse.fixed_view::<2, 2>(6, 6) * body.stiffness_matrix();
    // 2 x 2: the larger eigenvalue from trace and determinant
    let (half_trace, determinant) = (0.5 * matrix.trace(), matrix.determinant());
    (half_trace + (half_trace * half_trace - determinant).sqrt()).sqrt()
}

#[test]
fn a_step_of_a_thousand_periods_is_stable() {
    let step = 0.01;
    assert!(step * largest_frequency() > 1e3, "{}", largest_frequency());
    let mut body = stiff();
    let energy = body.kinetic_energy();
    let momentum = body.angular_momentum();
    for _ in 0..1_000 {
        body.step_linearly_implicit(step, &()).unwrap();
    }
    // ten seconds, almost four turns: second order in 0.01 times the spin of 2.3 rad/s
    assert!(
        (body.kinetic_energy() - energy).abs() < SLOW_MOTION_AT_LARGE_STEP * energy,
        "{} {energy}",
        body.kinetic_energy()
    );
    assert!((body.angular_momentum() - momentum).norm() < SLOW_MOTION_AT_LARGE_STEP * momentum.norm());
    assert!(body.elastic_energy() < QUIET_STIFF_MODES * energy);
}

#[test]
fn the_explicit_method_is_refused_its_infinities() {
    let mut body = stiff().with_deformation(Vector2::new(1e-6, 0.0), Vector2::zeros());
    let mut last = body;
    let failure = (0..1_000).find_map(|_| {
        last = body;
        body.step_rk4(0.01, &()).err()
    });
    assert_eq!(failure, Some(StepError::NonFiniteResult { largest_stable_step: None }));
    // the refused step left everything as it was
    assert_eq!(body, last);
    assert!(body.state.is_finite());
}

#[test]
fn stiff_modes_converge_to_the_rigid_body() {
    // the same cloud without modes
    let run_rigid = |steps: usize| {
        let mut body = FreeBody::new(cloud::<0, 6>(7, 0.0, 0.0).0).with_spin(Vector3::new(1.0, 2.0, -0.5));
        for _ in 0..steps {
            body.step_rk4(1.0 / steps as f64, &()).unwrap();
        }
        body.state
    };
    let rigid = run_rigid(1_000);
    let error = |steps: usize| {
        let mut body = stiff();
        for _ in 0..steps {
            body.step_linearly_implicit(1.0 / steps as f64, &()).unwrap();
        }
        (body.state.angular_velocity - rigid.angular_velocity).norm()
            + (body.state.position - rigid.position).norm()
    };
    // no order reduction in the slow motion although h ω_max stays in the thousands
    let order = measured_order(50, 3, error);
    assert!((order - 2.0).abs() < SLOPE, "{order}");
}

#[test]
fn stiff_modes_settle_in_static_equilibrium() {
    // a follower force and gravity on a spinning stiff body: q stays of the order force / stiffness
    let (kernels, markers) = cloud::<2, 8>(7, STIFFNESS, 1e3);
    let load = (
        Gravity { acceleration: Vector3::new(0.0, 0.0, -9.81) },
        MarkerLoad::force(markers[0], Vector3::new(20.0, 0.0, 5.0), Frame::Body),
    );
    let mut body = FreeBody::new(kernels)
        .with_spin(Vector3::new(0.5, 0.0, 0.1))
        .with_deformation(Vector2::new(1e-5, -1e-5), Vector2::zeros());
    for _ in 0..200 {
        body.step_linearly_implicit(0.01, &load).unwrap();
    }
    let deflection = body.state.modal_coordinates.amax();
    assert!(deflection < 1e3 / STIFFNESS && deflection > 1e-2 / STIFFNESS, "{deflection}");
    // and it is the deflection that makes the modal accelerations as small as the rigid ones
    let accelerations = body.acceleration(&load).to_vector::<8>();
    assert!(accelerations.amax() < 1e3, "{accelerations}");
}
