//! Free flight of the reference body, against a trajectory computed elsewhere.

use ffrf_test_kit::reference;
use ffrf_test_kit::tolerances::REFERENCE_TRAJECTORY;

#[test]
fn small_steps_follow_the_free_trajectory() {
    let Some(file) = reference::read("traj_free_synth_m3.json") else { return };
    let (deviation, block) = reference::follow::<3, 9>(&file, 2.5e-4, |body, step, _| {
        body.step_rk4(step, &()).unwrap();
    });
    eprintln!("free trajectory: worst relative deviation {deviation:.1e} in {block}");
    assert!(deviation < REFERENCE_TRAJECTORY, "{deviation} in {block}");
}

#[test]
fn the_linearly_implicit_step_follows_it_at_second_order() {
    let Some(file) = reference::read("traj_free_synth_m3.json") else { return };
    let order = ffrf_test_kit::convergence::measured_order(10, 2, |steps| {
        // steps per sample interval of 0.2 s, times 50
        let follow = reference::follow::<3, 9>(&file, 0.2 / (50 * steps) as f64, |body, step, _| {
            body.step_linearly_implicit(step, &()).unwrap();
        });
        follow.0
    });
    assert!((order - 2.0).abs() < ffrf_test_kit::tolerances::SLOPE, "{order}");
}
