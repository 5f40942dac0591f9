//! States that are saved and taken up again, bit by bit.

use ffrf_fmu::Instance;

use crate::scenes::{ROTOR, Unpacked, known};

/// Scenes of every way to step: explicit, with error control, in joint coordinates, with memory, with events.
fn scenes() -> Vec<(&'static str, Unpacked)> {
    let pendulum = std::fs::read_to_string(known("flexible_pendulum.toml")).unwrap();
    let alpha = pendulum.replace("\"linearly_implicit\"", "\"generalized_alpha\"");
    assert_ne!(alpha, pendulum);
    let minimal = ROTOR.replace("step = 1e-2", "step = 1e-2\nconstraints = \"minimal\"");
    let event = format!("{ROTOR}\n[events.quarter]\nsensor = \"turn\"\nvalue = 0.05\n");
    vec![
        ("explicit", Unpacked::of_text(ROTOR)),
        ("linearly implicit", Unpacked::of_text(&pendulum)),
        ("memory", Unpacked::of_text(&alpha)),
        ("joint coordinates", Unpacked::of_text(&minimal)),
        ("events", Unpacked::of_text(&event)),
        ("error control", Unpacked::of(&known("double_pendulum.toml"))),
    ]
}

/// A communication step that is no multiple of the steps of the scenes. Units: s.
const STEP: f64 = 2.3e-3;

/// Goes on from the `first` communication point, with another input at each of them.
fn run(scene: &Unpacked, instance: &mut Instance, points: std::ops::Range<u32>) -> Vec<Vec<u64>> {
    let input = scene.model.variables.iter().position(|variable| variable.name == "motor.input");
    points
        .map(|point| {
            let time = f64::from(point) * STEP;
            // none, then a new one at every third point
            if let (Some(input), true) = (input, point > 2 && point % 3 == 0) {
                instance.set(u32::try_from(input).unwrap(), time * 40.0 - 0.1).unwrap();
            }
            instance.step(time, STEP).unwrap();
            scene.bits(instance)
        })
        .collect()
}

#[test]
fn a_state_that_is_taken_up_again_goes_on_bit_by_bit() {
    for (name, scene) in scenes() {
        let mut instance = scene.begun();
        run(&scene, &mut instance, 0..5);
        let saved = instance.save();
        let now = scene.bits(&mut instance);
        let there = run(&scene, &mut instance, 5..15);
        // in the same instance
        instance.resume(&saved).unwrap();
        assert_eq!(scene.bits(&mut instance), now, "{name}");
        assert_eq!(instance.save(), saved, "{name}");
        assert_eq!(run(&scene, &mut instance, 5..15), there, "{name}");
        // as bytes, in one that has never begun
        let bytes = instance.write_state(&saved);
        let mut other = scene.instance();
        let read = other.read_state(&bytes).unwrap();
        assert_eq!(read, saved, "{name}");
        other.resume(&read).unwrap();
        assert_eq!(scene.bits(&mut other), now, "{name}");
        assert_eq!(run(&scene, &mut other, 5..15), there, "{name}");
    }
}

#[test]
fn a_state_keeps_the_parameters_that_were_set() {
    let scene = Unpacked::of_text(ROTOR);
    let mut heavy = scene.instance();
    heavy.set(scene.reference("forces.motor.gain"), 3.0).unwrap();
    heavy.enter_initialisation(0.0).unwrap();
    heavy.exit_initialisation().unwrap();
    run(&scene, &mut heavy, 0..2);
    let saved = heavy.save();
    let there = run(&scene, &mut heavy, 2..8);
    let mut other = scene.begun();
    other.resume(&saved).unwrap();
    assert_eq!(other.get(scene.reference("forces.motor.gain")).unwrap(), 3.0);
    assert_eq!(run(&scene, &mut other, 2..8), there);
}

#[test]
fn states_of_before_the_beginning_lead_back_there() {
    let scene = Unpacked::of_text(ROTOR);
    let mut rotor = scene.instance();
    let saved = rotor.save();
    rotor.set(scene.reference("simulation.step"), 5e-3).unwrap();
    rotor.enter_initialisation(0.0).unwrap();
    rotor.resume(&saved).unwrap();
    assert_eq!(rotor.get(scene.reference("simulation.step")).unwrap(), 1e-2);
    rotor.enter_initialisation(0.0).unwrap();
    rotor.exit_initialisation().unwrap();
}

#[test]
fn bytes_of_other_models_and_cut_bytes_are_refused() {
    let (scene, other) = (Unpacked::of_text(ROTOR), Unpacked::of_text(&ROTOR.replace("8.0", "9.0")));
    let rotor = scene.begun();
    let bytes = rotor.write_state(&rotor.save());
    let error = other.begun().read_state(&bytes).unwrap_err();
    assert_eq!(error.to_string(), "the state is not one of this model");
    for length in [0, 10, bytes.len() - 1] {
        assert!(rotor.read_state(&bytes[..length]).is_err(), "{length} bytes");
    }
    // whole numbers that are too few are a point that fits no scene
    let mut short = rotor.read_state(&bytes[..bytes.len() - 8]).unwrap();
    let mut rotor = rotor;
    let before = scene.bits(&mut rotor);
    assert!(rotor.resume(&short).is_err());
    assert_eq!(scene.bits(&mut rotor), before, "a refused state changes nothing");
    short = rotor.save();
    rotor.resume(&short).unwrap();
}
