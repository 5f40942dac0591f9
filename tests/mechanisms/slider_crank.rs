//! A driven slider-crank with a flexible rod.

use crate::bodies::{BIG_END, RADIUS, Rod, SMALL_END, SliderCrank, SliderCrankState};

/// The stroke of the piston if the rod were rigid.
fn stroke(angle: f64) -> f64 {
    let length = SMALL_END - BIG_END;
    RADIUS * angle.cos() + (length * length - (RADIUS * angle.sin()).powi(2)).sqrt()
}

#[test]
fn the_piston_follows_the_crank() {
    let model = SliderCrank::new(Rod);
    let mut mechanism = model.in_motion(SliderCrankState::stretched(&model));
    mechanism.assemble().unwrap();
    // both dead centres are passed
    for _ in 0..7000 {
        mechanism.step_linearly_implicit(1e-5).unwrap();
    }
    let angle = 100.0 * mechanism.time;
    assert!(angle > 6.5);
    let found = model.stroke(&mechanism.state).x;
    // the rod is stretched and bent by some micrometres
    assert!((found - stroke(angle)).abs() < 2e-5, "{found} {}", stroke(angle));
    let turn = model.turn(&mechanism.state);
    assert!((turn - (angle - std::f64::consts::TAU)).abs() < 1e-9, "{turn} {angle}");
    assert!(mechanism.state.rod.modal_coordinates.amax() > 0.0);
}

#[test]
fn drives_can_be_changed_between_steps() {
    let mut model = SliderCrank::new(Rod);
    model.motor =
        ffrf::mechanism::Drive::Function(|time: f64| [0.5 * time.sin(), 0.5 * time.cos(), -0.5 * time.sin()]);
    let mut mechanism = model.in_motion(SliderCrankState::stretched(&model));
    mechanism.assemble().unwrap();
    for _ in 0..100 {
        mechanism.step_rk4(2e-6).unwrap();
    }
    assert!((model.turn(&mechanism.state) - 0.5 * mechanism.time.sin()).abs() < 1e-12);
}
