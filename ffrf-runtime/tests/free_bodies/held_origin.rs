//! Bodies held at their frame origin: the heavy top of the literature and the flexible pendulum.

use approx::assert_relative_eq;
use ffrf_runtime::nalgebra::Vector3;
use ffrf_runtime::{FreeBody, Gravity, rotation};
use ffrf_test_kit::bodies::rigid_about;
use ffrf_test_kit::convergence::measured_order;
use ffrf_test_kit::held::HeldAtOrigin;
use ffrf_test_kit::reference;
use ffrf_test_kit::tolerances::{CONSERVED_BY_RK4, HEAVY_TOP_IN_PRINT, SLOPE, SOLVED};

#[test]
fn the_heavy_top_turns_as_in_the_literature() {
    // m = 15 kg, J = diag(0.234375, 0.46875, 0.234375) about the centre of mass (0, 1, 0), ω = (0, 150, -4.61538);
    // source: Brüls, Cardona, Arnold (2012), as in Exudyn's TestModels/heavyTop.py, which prints θ at 0.2 s
    let gravity = Gravity { acceleration: Vector3::new(0.0, 0.0, -9.81) };
    let kernels = rigid_about(15.0, Vector3::y(), Vector3::new(0.234_375, 0.468_75, 0.234_375));
    let mut body = FreeBody::new(kernels).with_spin(Vector3::new(0.0, 150.0, -4.61538));
    let load = HeldAtOrigin(gravity);
    let energy = body.kinetic_energy() + body.potential_energy(&gravity.acceleration);
    for _ in 0..4_000 {
        body.step_rk4(5e-5, &load).unwrap();
    }
    assert!(body.state.position.norm() < CONSERVED_BY_RK4);
    let now = body.kinetic_energy() + body.potential_energy(&gravity.acceleration);
    assert_relative_eq!(now, energy, max_relative = CONSERVED_BY_RK4);
    let theta = rotation::euler_parameters(&body.state.orientation);
    let sign = if theta[0] < 0.0 { 1.0 } else { -1.0 };
    for (found, printed) in theta.iter().zip([-0.70828, 0.43878, 0.54573, 0.0894]) {
        assert!((sign * found - printed).abs() < HEAVY_TOP_IN_PRINT, "{theta:?}");
    }
}

#[test]
fn the_flexible_pendulum_converges_to_the_reference() {
    let Some(file) = reference::read("traj_pendulum_beam_m4.json") else { return };
    // the fastest modes are barely resolved by these steps: the error is visible, and its order is the proof
    let order = measured_order(1, 2, |refinement| {
        let step = 5e-4 / refinement as f64;
        let (deviation, block) = reference::follow::<4, 10>(&file, step, |body, step, gravity| {
            body.step_rk4(step, &HeldAtOrigin(*gravity)).unwrap();
        });
        eprintln!("pendulum, step {step} s: worst relative deviation {deviation:.1e} in {block}");
        deviation
    });
    assert!((order - 4.0).abs() < SLOPE, "{order}");
}

#[test]
fn the_reaction_of_the_pendulum_is_that_of_the_reference() {
    let Some(file) = reference::read("traj_pendulum_beam_m4.json") else { return };
    let body = reference::start::<4, 10>(&file);
    let reaction = HeldAtOrigin(reference::gravity(&file)).reaction(&body.body, 0.0, &body.state);
    let expected = reference::vector(&file["samples"][0]["reaction"]);
    let error = (body.state.to_inertial(&reaction) - expected).norm() / expected.norm();
    assert!(error < SOLVED, "{error}");
}
