//! What is refused, with a message that says why.

use ffrf_fmu::Model;

use crate::scenes::{ROTOR, Unpacked, known};

#[test]
fn calls_out_of_order_say_where_the_instance_is() {
    let scene = Unpacked::of_text(ROTOR);
    let mut rotor = scene.instance();
    let error = rotor.step(0.0, 0.1).unwrap_err().to_string();
    assert_eq!(error, "a step is not allowed: the instance is instantiated, it must be in step mode");
    assert!(rotor.exit_initialisation().is_err());
    rotor.enter_initialisation(0.0).unwrap();
    assert!(rotor.enter_initialisation(0.0).is_err());
    rotor.exit_initialisation().unwrap();
    rotor.terminate().unwrap();
    assert!(rotor.step(0.0, 0.1).is_err());
}

#[test]
fn steps_begin_where_the_last_ended_and_go_forwards() {
    let scene = Unpacked::of_text(ROTOR);
    let mut rotor = scene.begun();
    for (from, size) in
        [(0.1, 0.1), (0.0, 0.0), (0.0, -0.1), (0.0, f64::NAN), (f64::NAN, 0.1), (0.0, f64::INFINITY)]
    {
        let before = scene.bits(&mut rotor);
        let error = rotor.step(from, size).unwrap_err().to_string();
        assert!(error.contains("expected a positive step from t = 0e0 s"), "{error}");
        assert_eq!(scene.bits(&mut rotor), before);
    }
}

#[test]
fn what_cannot_be_set_is_named() {
    let scene = Unpacked::of_text(ROTOR);
    let mut rotor = scene.begun();
    for (name, value, message) in [
        (
            "simulation.gravity.x",
            1.0,
            "`simulation.gravity.x` cannot be set: parameters are fixed once the simulation has begun",
        ),
        ("turn", 1.0, "`turn` cannot be set: it is what the simulation computes"),
        ("time", 1.0, "`time` cannot be set: it is what the simulation computes"),
        ("motor.input", f64::NAN, "`motor.input`: expected a finite number, found NaN"),
    ] {
        assert_eq!(rotor.set(scene.reference(name), value).unwrap_err().to_string(), message);
    }
    let last = scene.model.variables.len() - 1;
    let error = rotor.get(1000).unwrap_err().to_string();
    assert_eq!(error, format!("value reference 1000: expected one of 0 to {last}"));
}

#[test]
fn parameters_that_make_no_scene_are_refused_by_their_key() {
    let scene = Unpacked::of_text(ROTOR);
    let mut rotor = scene.instance();
    rotor.set(scene.reference("simulation.step"), -1.0).unwrap();
    rotor.enter_initialisation(0.0).unwrap();
    let error = rotor.exit_initialisation().unwrap_err().to_string();
    assert!(error.contains("simulation.step") && error.contains("positive"), "{error}");
    // and can be put right
    rotor.set(scene.reference("simulation.step"), 1e-3).unwrap();
    rotor.exit_initialisation().unwrap();
}

#[test]
fn a_step_that_leads_nowhere_leaves_the_instance_where_it_was() {
    // far above the largest stable step of the explicit method
    let scene = Unpacked::of(&known("slider_crank.toml"));
    let mut crank = scene.instance();
    crank.set(scene.reference("simulation.step"), 1e-3).unwrap();
    crank.enter_initialisation(0.0).unwrap();
    crank.exit_initialisation().unwrap();
    let before = scene.bits(&mut crank);
    let error = crank.step(0.0, 0.05).unwrap_err().to_string();
    assert!(error.contains("joint") || error.contains("step"), "{error}");
    assert_eq!(scene.bits(&mut crank), before);
}

#[test]
fn two_variables_of_one_name_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, ROTOR.replace("[sensors.turn]", "[sensors.time]")).unwrap();
    let error = Model::of_scene(&path).err().unwrap().to_string();
    assert!(error.contains("two variables of the FMU would be called `time`"), "{error}");
}
