//! Loads and markers: powers, work, and their place in the equations.

use approx::assert_relative_eq;
use ffrf_runtime::nalgebra::{SVector, UnitQuaternion, Vector3};
use ffrf_runtime::{
    DenseForms, Frame, FreeBody, GeneralisedForce, Gravity, Load, MarkerLoad, Observables, State,
};
use ffrf_test_kit::bodies::cloud;
use ffrf_test_kit::naive_body::NaiveBody;
use ffrf_test_kit::tolerances::{CENTRED_DIFFERENCE, CONSERVED_BY_RK4, ROUND_OFF, SOLVED};

type Kernels = NaiveBody<3, 9>;
type Modal = SVector<f64, 3>;
type Rigid = SVector<f64, 0>;

fn flying() -> FreeBody<Kernels> {
    FreeBody::new(cloud::<3, 9>(11, 30.0, 0.0).0)
        .with_position(Vector3::new(0.4, -0.1, 0.2))
        .with_orientation(UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.8, 0.5)))
        .with_velocity(Vector3::new(0.5, -0.4, 0.2))
        .with_spin(Vector3::new(1.0, 2.0, -0.5))
        .with_deformation(Vector3::new(0.2, -0.1, 0.05), Vector3::new(0.3, 0.5, -0.4))
}

#[test]
fn generalised_forces_have_the_power_of_the_force_and_of_the_moment() {
    let body = flying();
    let marker = cloud::<3, 9>(11, 30.0, 0.0).1[2];
    let vector = Vector3::new(1.3, -0.4, 0.8);
    for frame in [Frame::Inertial, Frame::Body] {
        let inertial = if frame == Frame::Body { body.state.to_inertial(&vector) } else { vector };
        let force = body.generalised_force(&MarkerLoad::force(marker, vector, frame));
        let power = inertial.dot(&body.marker_velocity(&marker));
        assert_relative_eq!(force.power(&body.state.velocities()), power, max_relative = ROUND_OFF);

        let moment = body.generalised_force(&MarkerLoad::moment(marker, vector, frame));
        let State { modal_coordinates, angular_velocity, modal_rates, .. } = &body.state;
        let spin = marker.angular_velocity(modal_coordinates, angular_velocity, modal_rates);
        let power = inertial.dot(&body.state.to_inertial(&spin));
        assert_relative_eq!(moment.power(&body.state.velocities()), power, max_relative = ROUND_OFF);
    }
}

#[test]
fn marker_velocity_is_the_rate_of_marker_position() {
    let body = flying();
    let marker = cloud::<3, 9>(11, 30.0, 0.0).1[5];
    let shifted = |time: f64| {
        let mut moved = body;
        moved.state.position += body.state.velocity * time;
        moved.state.orientation *= UnitQuaternion::from_scaled_axis(body.state.angular_velocity * time);
        moved.state.modal_coordinates += body.state.modal_rates * time;
        moved.marker_position(&marker)
    };
    let rate = (shifted(1e-5) - shifted(-1e-5)) / 2e-5;
    assert!((rate - body.marker_velocity(&marker)).norm() < CENTRED_DIFFERENCE);
}

#[test]
fn gravity_is_the_weight_of_the_points_of_the_cloud() {
    // equal accelerations α + ω̇ × ... of all points: a body at rest falls with q̈ = ω̇ = 0
    let gravity = Gravity { acceleration: Vector3::new(1.0, 2.0, -9.0) };
    let body = flying().with_spin(Vector3::zeros()).with_deformation(SVector::zeros(), SVector::zeros());
    let acceleration = body.acceleration(&gravity);
    let expected = body.state.to_body(&gravity.acceleration);
    assert!((acceleration.linear - expected).norm() < SOLVED);
    assert!(acceleration.angular.norm() < SOLVED, "{acceleration:?}");
    assert!(acceleration.modal.norm() < SOLVED, "{acceleration:?}");
}

#[test]
fn mass_and_first_moment_are_those_of_the_mass_matrix() {
    let body = flying();
    let mass = body.body.mass_matrix(&body.state.modal_coordinates);
    assert_relative_eq!(body.body.mass(), mass[(0, 0)], max_relative = ROUND_OFF);
    let moment = body.body.first_mass_moment(&body.state.modal_coordinates);
    // -m r~ in the block of translation and rotation
    let expected = Vector3::new(mass[(1, 5)], mass[(2, 3)], mass[(0, 4)]);
    assert!((moment - expected).norm() < ROUND_OFF, "{moment} {expected}");
}

#[test]
fn work_of_a_marker_force_is_the_change_of_energy() {
    let marker = cloud::<3, 9>(11, 30.0, 0.0).1[1];
    let inertial = Vector3::new(3.0, -2.0, 4.0);
    let load = MarkerLoad::force(marker, inertial, Frame::Inertial);
    let mut body = flying();
    let energy = |body: &FreeBody<Kernels>| body.kinetic_energy() + body.elastic_energy();
    let (before, start, linear) = (energy(&body), body.marker_position(&marker), body.linear_momentum());
    for _ in 0..4_000 {
        body.step_rk4(2.5e-4, &load).unwrap();
    }
    // a constant force does the work f · displacement of its point, and gives the momentum f t
    let work = inertial.dot(&(body.marker_position(&marker) - start));
    assert!(work.abs() > 1.0, "{work}");
    assert_relative_eq!(energy(&body) - before, work, max_relative = CONSERVED_BY_RK4);
    assert!((body.linear_momentum() - linear - inertial * body.time).norm() < CONSERVED_BY_RK4);
}

#[test]
fn a_follower_moment_changes_angular_momentum_at_its_rate() {
    let marker = cloud::<3, 9>(11, 30.0, 0.0).1[3];
    let moment = Vector3::new(0.3, -0.2, 0.4);
    let load = MarkerLoad::moment(marker, moment, Frame::Inertial);
    let mut body = flying();
    let (linear, angular) = (body.linear_momentum(), body.angular_momentum());
    for _ in 0..4_000 {
        body.step_rk4(2.5e-4, &load).unwrap();
    }
    assert!((body.linear_momentum() - linear).norm() < CONSERVED_BY_RK4);
    assert!((body.angular_momentum() - angular - moment * body.time).norm() < CONSERVED_BY_RK4);
}

#[test]
fn loads_add_up_and_know_the_time() {
    let body = flying();
    let gravity = Gravity { acceleration: Vector3::new(0.0, 0.0, -9.81) };
    let ramp = |_: &Kernels, time: f64, _: &State<Modal>, force: &mut GeneralisedForce<Modal>| {
        force.moment.z += 2.0 * time
    };
    let both = (gravity, ramp);
    let mut later = body;
    later.time = 3.0;
    let alone = body.generalised_force(&gravity).to_vector::<9>();
    let difference = later.generalised_force(&both).to_vector::<9>() - alone;
    assert_eq!(difference[5], 6.0);
    assert_eq!(difference.norm(), 6.0);
    // a moment that grows with time: the order of both methods must survive explicit time
    let mut spun = FreeBody::new(ffrf_test_kit::bodies::rigid(1.0, Vector3::new(1.0, 1.0, 2.0)));
    let ramp = |_: &NaiveBody<0, 6>, time: f64, _: &State<Rigid>, force: &mut GeneralisedForce<Rigid>| {
        force.moment.z += time
    };
    spun.step_rk4(0.5, &ramp).unwrap();
    spun.step_linearly_implicit(0.5, &ramp).unwrap();
    // ω_z = t² / (2 I_z)
    assert_relative_eq!(spun.state.angular_velocity.z, 0.25, max_relative = ROUND_OFF);
    let _: &dyn Load<NaiveBody<0, 6>, State<Rigid>, GeneralisedForce<Rigid>> = &ramp;
}
