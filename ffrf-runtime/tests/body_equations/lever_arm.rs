//! Lever arms of forces and Jacobians of marker positions: exact with the deformed one, off by Ψ q with the other.

use ffrf_runtime::forms::LeverArm::{Deformed, Undeformed};
use ffrf_runtime::forms::{
    EulerParameterForm, LeverArm, force_about, marker_position_jacobian, marker_velocity_jacobian,
};
use ffrf_runtime::nalgebra::{DMatrix, Quaternion, SMatrix, SVector, UnitQuaternion, Vector3};
use ffrf_runtime::rotation::euler_parameters;
use ffrf_runtime::{DenseForms, FlexibleBody, Frame, FreeBody, GeneralisedForce, Marker, MarkerLoad};
use ffrf_test_kit::bodies::{cloud, cloud_masses};
use ffrf_test_kit::naive_body::NaiveBody;
use ffrf_test_kit::tolerances::{CENTRED_DIFFERENCE, ROUND_OFF, SOLVED};

const SEED: u64 = 11;

fn body() -> (NaiveBody<3, 9>, [Marker<SVector<f64, 3>>; 8]) {
    cloud::<3, 9>(SEED, 30.0, 0.0)
}

fn coordinates() -> SVector<f64, 3> {
    Vector3::new(0.2, -0.1, 0.05)
}

/// [v; ω; q̇] without any symmetry.
fn velocities() -> SVector<f64, 9> {
    SVector::from([0.5, -0.4, 0.2, 1.0, 2.0, -0.5, 0.3, 0.5, -0.4])
}

fn elastic_part(marker: &Marker<SVector<f64, 3>>, q: &SVector<f64, 3>) -> Vector3<f64> {
    marker.position(q) - marker.position
}

#[test]
fn jacobian_times_velocities_is_the_velocity_of_the_marker() {
    let (q, w) = (coordinates(), velocities());
    let [velocity, omega, q_dot] = [0, 3, 6].map(|start| w.fixed_rows::<3>(start).into_owned());
    for marker in body().1 {
        let exact = marker.velocity(&q, &velocity, &omega, &q_dot);
        let complete: SMatrix<f64, 3, 9> = marker_velocity_jacobian(&marker, &q, Deformed);
        assert!((complete * w - exact).norm() < ROUND_OFF);
        // As printed in (215), it misses just ω × Ψ q.
        let printed: SMatrix<f64, 3, 9> = marker_velocity_jacobian(&marker, &q, Undeformed);
        let missing = omega.cross(&elastic_part(&marker, &q));
        assert!(missing.norm() > 1e-3);
        assert!((printed * w + missing - exact).norm() < ROUND_OFF);
    }
}

#[test]
fn the_complete_jacobian_is_the_derivative_of_the_position() {
    let orientation = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.8, 0.5));
    let origin = Vector3::new(0.4, -0.1, 0.2);
    let marker = body().1[5];
    let parameters = euler_parameters(&orientation);
    let mut start = SVector::<f64, 10>::zeros();
    start.fixed_rows_mut::<3>(0).copy_from(&origin);
    start.fixed_rows_mut::<4>(3).copy_from_slice(&parameters);
    start.fixed_rows_mut::<3>(7).copy_from(&coordinates());
    let position = |y: &SVector<f64, 10>| {
        let turned = UnitQuaternion::from_quaternion(Quaternion::new(y[3], y[4], y[5], y[6]));
        y.fixed_rows::<3>(0) + turned * marker.position(&y.fixed_rows::<3>(7).into_owned())
    };
    let complete: SMatrix<f64, 3, 10> =
        marker_position_jacobian(&marker, &orientation, &coordinates(), Deformed);
    for column in 0..10 {
        let mut step = SVector::<f64, 10>::zeros();
        step[column] = 1e-5;
        let difference = (position(&(start + step)) - position(&(start - step))) / 2e-5;
        assert!((difference - complete.column(column)).norm() < CENTRED_DIFFERENCE, "column {column}");
    }
    // Both forms of both versions are one another's transformation; no part of it is along θ.
    for lever_arm in [Deformed, Undeformed] {
        let resolved: SMatrix<f64, 3, 9> = marker_velocity_jacobian(&marker, &coordinates(), lever_arm);
        let form: SMatrix<f64, 3, 10> =
            marker_position_jacobian(&marker, &orientation, &coordinates(), lever_arm);
        assert!((EulerParameterForm::<10>::jacobian(&orientation, &resolved) - form).norm() < ROUND_OFF);
        let along = form.fixed_columns::<4>(3) * SVector::<f64, 4>::from(parameters);
        assert!(along.norm() < ROUND_OFF);
    }
    // As printed in (215), the columns of θ are off by A (Ψ q)~ Ḡ, and no others.
    let printed: SMatrix<f64, 3, 10> =
        marker_position_jacobian(&marker, &orientation, &coordinates(), Undeformed);
    let off = complete - printed;
    assert!(off.fixed_columns::<4>(3).norm() > 1e-2);
    assert_eq!(off.fixed_columns::<3>(0).norm() + off.fixed_columns::<3>(7).norm(), 0.0);
}

#[test]
fn forces_are_the_transposed_jacobian_and_their_power_balances_with_the_deformed_lever_arm_only() {
    let (q, w) = (coordinates(), velocities());
    let force = Vector3::new(1.3, -0.4, 0.8);
    for marker in body().1 {
        for lever_arm in [Deformed, Undeformed] {
            let about: SVector<f64, 9> = force_about(&marker, &q, &force, lever_arm);
            let jacobian: SMatrix<f64, 3, 9> = marker_velocity_jacobian(&marker, &q, lever_arm);
            assert!((jacobian.tr_mul(&force) - about).norm() < ROUND_OFF);
        }
        let power = |generalised: SVector<f64, 9>| generalised.dot(&w);
        let complete: SMatrix<f64, 3, 9> = marker_velocity_jacobian(&marker, &q, Deformed);
        let exact = force.dot(&(complete * w));
        assert!((power(marker.force(&q, &force).to_vector()) - exact).abs() < ROUND_OFF);
        assert_eq!(
            marker.force(&q, &force).to_vector::<9>(),
            force_about::<3, 9, f64>(&marker, &q, &force, Deformed)
        );
        // What is missing is the power of the moment Ψ q × f.
        let omega: Vector3<f64> = w.fixed_rows::<3>(3).into_owned();
        let missing = elastic_part(&marker, &q).cross(&force).dot(&omega);
        let about = power(force_about(&marker, &q, &force, Undeformed));
        assert!((about + missing - exact).abs() < ROUND_OFF && missing.abs() > 1e-4, "{missing}");
    }
}

#[test]
fn a_load_takes_the_deformed_lever_arm() {
    let (kernels, markers) = body();
    let flying = FreeBody::new(kernels).with_deformation(coordinates(), SVector::zeros());
    let force = Vector3::new(1.3, -0.4, 0.8);
    for frame in [Frame::Inertial, Frame::Body] {
        let load = flying.generalised_force(&MarkerLoad::force(markers[2], force, frame)).to_vector::<9>();
        let about = |arm| force_about::<3, 9, f64>(&markers[2], &coordinates(), &force, arm);
        assert!((load - about(Deformed)).norm() < ROUND_OFF);
        let difference = load - about(Undeformed);
        let moment = elastic_part(&markers[2], &coordinates()).cross(&force);
        assert!((difference.fixed_rows::<3>(3) - moment).norm() < ROUND_OFF);
        assert_eq!(difference.norm(), difference.fixed_rows::<3>(3).norm());
    }
}

/// ω̇ of free fall at rest with deformation `q`, elastic forces left out; each point carries its weight.
fn spurious_spin(q: &SVector<f64, 3>, lever_arm: LeverArm) -> f64 {
    let (kernels, markers) = body();
    let gravity = Vector3::new(0.0, 0.0, -9.81);
    let mut force = GeneralisedForce::zeros(q);
    for (marker, mass) in markers.iter().zip(cloud_masses(SEED)) {
        let about = force_about::<3, 9, f64>(marker, q, &(gravity * mass), lever_arm);
        force.add_scaled(1.0, &GeneralisedForce::from_vector(&about));
    }
    // The elastic force is taken back: the body falls as it is.
    force.modal += kernels.internal_force(q, &SVector::zeros());
    kernels.forward_dynamics(q, &Vector3::zeros(), &SVector::zeros(), &force).angular.norm()
}

#[test]
fn free_fall_turns_a_deformed_body_by_the_undeformed_lever_arm_in_proportion_to_the_deflection() {
    let q = coordinates();
    assert!(spurious_spin(&q, Deformed) < SOLVED);
    assert!(spurious_spin(&q, Undeformed) > 1e-1);
    assert!(spurious_spin(&SVector::zeros(), Undeformed) < SOLVED);
    let [one, half] = [1e-4, 5e-5].map(|scale| spurious_spin(&(q * scale), Undeformed));
    // To first order linear; the next order is 1e-4 of it.
    assert!((one / half - 2.0).abs() < 1e-3, "{one:e} {half:e}");
}

#[test]
fn a_spherical_joint_does_work_by_the_printed_jacobian_only() {
    let (kernels, markers) = body();
    let (q, marker) = (coordinates(), markers[4]);
    // Velocities that hold the marker: v = -ω × (x + Ψ q) - Ψ q̇.
    let mut w = velocities();
    let complete: SMatrix<f64, 3, 9> = marker_velocity_jacobian(&marker, &q, Deformed);
    let slip = complete * w;
    for i in 0..3 {
        w[i] -= slip[i];
    }
    let omega: Vector3<f64> = w.fixed_rows::<3>(3).into_owned();
    for lever_arm in [Deformed, Undeformed] {
        // Multipliers and accelerations of [M Cᵀ; C 0] with the body at rest otherwise.
        let jacobian: SMatrix<f64, 3, 9> = marker_velocity_jacobian(&marker, &q, lever_arm);
        let gravity = kernels.gravity_force(&q, &Vector3::new(0.3, -0.2, -9.81)).to_vector::<9>();
        let mass = kernels.mass_matrix(&q);
        let system = DMatrix::from_fn(12, 12, |i, j| match (i < 9, j < 9) {
            (true, true) => mass[(i, j)],
            (true, false) => jacobian[(j - 9, i)],
            (false, true) => jacobian[(i - 9, j)],
            (false, false) => 0.0,
        });
        let right = DMatrix::from_fn(12, 1, |i, _| if i < 9 { gravity[i] } else { 0.0 });
        let solution = system.lu().solve(&right).unwrap();
        let multipliers = Vector3::new(solution[9], solution[10], solution[11]);
        assert!(multipliers.norm() > 1.0);
        let acceleration = SVector::<f64, 9>::from_fn(|i, _| solution[i]);
        let moves = (complete * acceleration).norm();
        let power = multipliers.dot(&(jacobian * w)).abs();
        let missing = multipliers.dot(&omega.cross(&elastic_part(&marker, &q))).abs();
        match lever_arm {
            Deformed => assert!(power < ROUND_OFF * 100.0 && moves < SOLVED, "{power:e} {moves:e}"),
            Undeformed => {
                assert!(
                    (power - missing).abs() < SOLVED && missing > 1e-1 && moves > 1e-2,
                    "{power} {missing} {moves}"
                );
            }
        }
    }
}

#[test]
fn a_rigid_marker_has_one_lever_arm() {
    let marker = Marker::rigid(Vector3::new(0.3, 0.1, -0.2), &coordinates());
    let force = Vector3::new(1.0, 2.0, 3.0);
    let about: SVector<f64, 9> = force_about(&marker, &coordinates(), &force, Undeformed);
    assert_eq!(about, marker.force(&coordinates(), &force).to_vector::<9>());
}
