//! The calls that `ffrf plan` prints, compiled as they are: `tests/golden/planned_slider_crank.rs`, which a test of ffrf-cli
//! compares with what the command prints.

use ffrf::nalgebra::Vector3;

include!("../golden/planned_slider_crank.rs");

/// Radius of the crank, as in `models/scenes/slider_crank.toml`. Units: m.
const RADIUS: f64 = 0.04;
/// What the rod is stretched and bent by, at most. Units: m.
const ELASTIC: f64 = 2e-5;

#[test]
fn what_a_plan_prints_compiles_and_turns() {
    let model = SliderCrank::new(Rod);
    let mut state = model.at_rest();
    let length = Rod::SMALL_END.position.x - Rod::BIG_END.position.x;
    state.rod.position = Vector3::new(RADIUS - Rod::BIG_END.position.x, 0.0, 0.0);
    state.piston.position = Vector3::new(RADIUS + length, 0.0, 0.0);
    let mut mechanism = model.in_motion(state);
    mechanism.assemble().unwrap();
    for _ in 0..40 {
        mechanism.step_linearly_implicit(1e-3).unwrap();
        let angle = 100.0 * mechanism.time;
        let rigid = RADIUS * angle.cos() + (length * length - (RADIUS * angle.sin()).powi(2)).sqrt();
        let found = model.stroke(&mechanism.state).x;
        assert!((found - rigid).abs() < ELASTIC, "{found} {rigid}");
    }
}
