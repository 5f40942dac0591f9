//! What inputs and parameters do, against the law of a rotor and against `simulate`.

use ffrf_host::scene::Scene;
use ffrf_host::simulate::simulate;

use crate::scenes::{ROTOR, Unpacked, known};

/// Round-off of some hundred steps, relative.
const ROUND_OFF: f64 = 1e-13;

/// Error of the method in turns of a few degrees a step, of order four. Units: rad.
const METHOD: f64 = 1e-6;

/// Moment of inertia of the rotor about its shaft. Units: kg m².
const INERTIA: f64 = 0.1;

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= ROUND_OFF * expected.abs().max(1.0), "{found} is not {expected}");
}

#[test]
fn an_input_acts_from_where_it_is_set_and_is_held() {
    let scene = Unpacked::of_text(ROTOR);
    let mut rotor = scene.begun();
    let (input, speed) = (scene.reference("motor.input"), scene.reference("rotor.angular_velocity.z"));
    let angle = scene.reference("turn");
    assert_eq!(rotor.get(input).unwrap(), 2.0);
    // off the grid of steps of a hundredth of a second, and without an input: the moment of the scene acts
    rotor.step(0.0, 0.1234).unwrap();
    near(rotor.get(speed).unwrap(), 2.0 * 0.1234 / INERTIA);
    // from here on another moment, for a constant moment the method is exact
    rotor.set(input, -5.0).unwrap();
    rotor.step(0.1234, 0.2).unwrap();
    let first = 2.0 * 0.1234 / INERTIA;
    near(rotor.get(speed).unwrap(), first - 5.0 * 0.2 / INERTIA);
    let turned = 0.5 * 2.0 * 0.1234 * 0.1234 / INERTIA + first * 0.2 - 0.5 * 5.0 * 0.2 * 0.2 / INERTIA;
    let error = rotor.get(angle).unwrap() - turned;
    assert!(error.abs() < METHOD, "{error:e}");
    // held without being set again, and the same value again changes nothing
    rotor.set(input, -5.0).unwrap();
    rotor.step(0.3234, 0.05).unwrap();
    near(rotor.get(speed).unwrap(), first - 5.0 * 0.25 / INERTIA);
    assert_eq!(rotor.get(input).unwrap(), -5.0);
}

#[test]
fn without_inputs_the_motion_is_that_of_simulate_wherever_communication_points_are() {
    for (name, step, count) in [
        ("rotor_run_up.toml", 5e-3, 40),
        ("rotor_run_up.toml", 3.3e-4, 40),
        ("flexible_pendulum.toml", 2.7e-3, 30),
    ] {
        let text = std::fs::read_to_string(known(name)).unwrap();
        let text: Vec<&str> = text.lines().filter(|line| !line.starts_with("output_step")).collect();
        let text =
            text.join("\n").replacen("[simulation]", &format!("[simulation]\noutput_step = {step:?}"), 1);
        let unpacked = Unpacked::of_text(&text);
        // the resources name their files otherwise: `simulate` runs the scene as it was
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.toml");
        let beside = known("").display().to_string();
        std::fs::write(&path, text.replace("\"../", &format!("\"{beside}/../"))).unwrap();
        let mut rows = Vec::new();
        let scene = Scene::read(&path).unwrap();
        simulate(
            &scene,
            None,
            |sample| {
                rows.push(sample.clone());
                Ok(())
            },
            |_| {},
        )
        .unwrap();
        let mut instance = unpacked.begun();
        for (index, row) in rows.iter().take(count).enumerate() {
            let bits: Vec<u64> = row.values.iter().map(|value| value.to_bits()).collect();
            assert_eq!(unpacked.bits(&mut instance), bits, "{name} at {}", row.time);
            instance.step(index as f64 * step, (index + 1) as f64 * step - index as f64 * step).unwrap();
        }
    }
}

#[test]
fn parameters_are_keys_of_the_scene() {
    let original = std::fs::read_to_string(known("flexible_pendulum.toml")).unwrap();
    let changed =
        original.replace("[0.0, -9.81, 0.0]", "[0.0, -1.62, 0.0]").replace("step = 1e-3", "step = 5e-4");
    let changed = changed
        .replace("[joints.pin]", "modal_rates = [0.0, 0.25, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]\n[joints.pin]");
    assert_ne!(original, changed);
    let (original, changed) = (Unpacked::of_text(&original), Unpacked::of_text(&changed));
    let mut one = original.instance();
    for (name, value) in
        [("simulation.gravity.y", -1.62), ("simulation.step", 5e-4), ("bodies.rod.modal_rates.2", 0.25)]
    {
        one.set(original.reference(name), value).unwrap();
        assert_eq!(one.get(original.reference(name)).unwrap(), value);
    }
    one.enter_initialisation(0.0).unwrap();
    one.exit_initialisation().unwrap();
    let mut other = changed.begun();
    for index in 0..20 {
        assert_eq!(original.bits(&mut one), changed.bits(&mut other));
        one.step(f64::from(index) * 1e-3, 1e-3).unwrap();
        other.step(f64::from(index) * 1e-3, 1e-3).unwrap();
    }
    // and a reset is the scene of the file again
    one.reset();
    one.enter_initialisation(0.0).unwrap();
    one.exit_initialisation().unwrap();
    assert_eq!(original.bits(&mut one), original.bits(&mut original.begun()));
}

#[test]
fn a_simulation_may_begin_later() {
    let text = ROTOR.replace("[2.0]", "[0.0, 3.0]");
    let scene = Unpacked::of_text(&text);
    let mut rotor = scene.instance();
    rotor.enter_initialisation(2.0).unwrap();
    rotor.exit_initialisation().unwrap();
    assert_eq!(rotor.get(0).unwrap(), 2.0);
    rotor.step(2.0, 0.5).unwrap();
    // the integral of 3 t from 2 to 2.5
    near(rotor.get(scene.reference("rotor.angular_velocity.z")).unwrap(), 1.5 * (6.25 - 4.0) / INERTIA);
}

#[test]
fn a_simulation_may_begin_before_zero_in_whole_steps_as_well() {
    let scene = Unpacked::of_text(ROTOR);
    let mut bits = Vec::new();
    for start in [-2.0, 0.0] {
        let mut rotor = scene.instance();
        rotor.enter_initialisation(start).unwrap();
        rotor.exit_initialisation().unwrap();
        rotor.step(start, 0.5).unwrap();
        bits.push(rotor.get(scene.reference("turn")).unwrap());
    }
    // fifty steps of a hundredth of a second, not one of half a second
    near(bits[0], bits[1]);
}
