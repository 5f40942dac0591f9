//! The same step twice gives the same bits; states are saved and restored exactly.

use crate::bodies::{Pendulum, Rod, SliderCrank, SliderCrankState, WholeRod};

#[test]
fn a_restored_state_goes_on_bit_by_bit() {
    let model = SliderCrank::new(Rod);
    let mut mechanism = model.in_motion(SliderCrankState::stretched(&model));
    mechanism.assemble().unwrap();
    for _ in 0..20 {
        mechanism.step_linearly_implicit(1e-5).unwrap();
    }
    let saved = mechanism.state.to_array();
    let mut restored = model.in_motion(model.state_from_array(&saved));
    restored.time = mechanism.time;
    assert_eq!(restored.state, mechanism.state);
    let mut again = mechanism;
    for _ in 0..20 {
        let report = mechanism.step_rk4(2e-6).unwrap();
        assert_eq!(again.step_rk4(2e-6).unwrap(), report);
        assert_eq!(restored.step_rk4(2e-6).unwrap(), report);
    }
    let bits = |state: &SliderCrankState| state.to_array().map(f64::to_bits);
    assert_eq!(bits(&again.state), bits(&mechanism.state));
    assert_eq!(bits(&restored.state), bits(&mechanism.state));
}

#[test]
fn the_numbers_of_a_state_are_counted_and_ordered() {
    assert_eq!(SliderCrankState::SIZE, 3 * 13 + 2 * 4);
    let model = Pendulum::new(WholeRod);
    let mut state = model.at_rest();
    state.rod.position.x = 1.0;
    state.rod.modal_coordinates[0] = 2.0;
    state.rod.velocity.x = 3.0;
    let numbers = state.to_array();
    assert_eq!((numbers[0], numbers[3], numbers[7]), (1.0, 1.0, 2.0));
    assert_eq!(numbers[7 + WholeRod::MODE_COUNT], 3.0);
}
