//! A body takes less than 60 lines by hand; all else comes with the traits, and is right.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

mod breathing;
mod rigid;

use breathing::Ball;
use ffrf_runtime::nalgebra::{SMatrix, SVector, Vector1, Vector3};
use ffrf_runtime::{DenseForms, FlexibleBody, FreeBody, Observables};
use ffrf_test_kit::naive_body::{Invariants, NaiveBody};
use ffrf_test_kit::tolerances::{CONSERVED_BY_RK4, ROUND_OFF};
use rigid::Brick;

#[test]
fn a_body_by_hand_is_short() {
    for (name, text) in [("rigid", include_str!("rigid.rs")), ("breathing", include_str!("breathing.rs"))] {
        let lines = text.lines().count();
        assert!(lines < 60, "{name}: {lines} lines");
    }
}

/// The equations of a body by hand against those of the same body by its invariants.
fn same_equations<B, const M: usize, const N: usize>(by_hand: &B, naive: &NaiveBody<M, N>)
where
    B: DenseForms<M, N> + Observables + FlexibleBody<Modal = SVector<f64, M>>,
{
    let q = SVector::<f64, M>::repeat(0.1);
    let q_dot = SVector::<f64, M>::repeat(-0.7);
    let (velocity, omega) = (Vector3::new(0.3, -0.2, 0.6), Vector3::new(1.0, 2.0, -0.5));
    let force = SVector::<f64, N>::from_fn(|k, _| 1.0 + k as f64);
    let found = by_hand.equations_of_motion(&q, &omega, &q_dot, &force);
    let expected = naive.equations_of_motion(&q, &omega, &q_dot, &force);
    let mass: SMatrix<f64, N, N> = found.mass_matrix - expected.mass_matrix;
    assert!(mass.amax() < ROUND_OFF);
    assert!((found.quadratic_velocity - expected.quadratic_velocity).amax() < ROUND_OFF);
    assert!((found.acceleration - expected.acceleration).amax() < ROUND_OFF * expected.acceleration.amax());
    let energy = by_hand.kinetic_energy(&q, &velocity, &omega, &q_dot) + by_hand.elastic_energy(&q);
    let exact = naive.kinetic_energy(&q, &velocity, &omega, &q_dot) + naive.elastic_energy(&q);
    assert!((energy - exact).abs() < ROUND_OFF * exact);
}

fn brick() -> Brick {
    Brick { mass: 2.0, principal: Vector3::new(1.0, 2.0, 2.5) }
}

fn ball() -> Ball {
    Ball { mass: 2.0, euler: 0.4, stiffness: 120.0 }
}

#[test]
fn a_brick_is_the_rigid_body_of_its_numbers() {
    same_equations(&brick(), &ffrf_test_kit::bodies::rigid(2.0, brick().principal));
}

#[test]
fn a_breathing_ball_is_the_body_of_its_invariants() {
    let tensor = [[0.4, 0.0, 0.0], [0.0, 0.4, 0.0], [0.0, 0.0, 0.4]];
    let invariants = Invariants {
        mass: 2.0,
        centre_of_mass: [0.0; 3],
        modal_centre_of_mass: [[0.0; 3]],
        euler_tensor: tensor,
        modal_euler_tensor: [tensor],
        modal_pair_euler_tensor: [[tensor]],
        stiffness: [[120.0]],
        damping: [[0.0]],
    };
    same_equations(&ball(), &NaiveBody::<1, 7>::new(&invariants));
}

#[test]
fn bodies_by_hand_fly_and_keep_energy_and_momentum() {
    let mut brick = FreeBody::new(brick()).with_spin(Vector3::new(0.02, 3.0, 0.1));
    let mut ball = FreeBody::new(ball())
        .with_velocity(Vector3::new(1.0, 0.5, 0.0))
        .with_spin(Vector3::new(0.1, 0.2, 3.0))
        .with_deformation(Vector1::new(0.1), Vector1::zeros());
    let energies = |brick: &FreeBody<Brick>, ball: &FreeBody<Ball>| {
        [brick.kinetic_energy(), ball.kinetic_energy() + ball.elastic_energy()]
    };
    let momenta =
        |brick: &FreeBody<Brick>, ball: &FreeBody<Ball>| [brick.angular_momentum(), ball.angular_momentum()];
    let before = (energies(&brick, &ball), momenta(&brick, &ball));
    for _ in 0..2_000 {
        brick.step_rk4(5e-4, &()).unwrap();
        ball.step_rk4(5e-4, &()).unwrap();
    }
    let after = (energies(&brick, &ball), momenta(&brick, &ball));
    for body in 0..2 {
        assert!((after.0[body] - before.0[body]).abs() < CONSERVED_BY_RK4 * before.0[body]);
        assert!((after.1[body] - before.1[body]).norm() < CONSERVED_BY_RK4 * before.1[body].norm());
    }
    assert!((ball.state.modal_coordinates.x - 0.1).abs() > 1e-3);
}
