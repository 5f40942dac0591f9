//! Friction and actuators of scene files against closed forms, and what their tables refuse.

use std::path::Path;

use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;
use ffrf_host::simulate::simulate;

fn compose(text: &str) -> Result<Scene, String> {
    let file = SceneFile::parse(text).map_err(|error| error.to_string())?;
    Scene::compose(&file, Path::new("")).map_err(|error| error.to_string())
}

/// Position, velocity (inertial) and angular velocity of the first body at the end.
fn end(text: &str) -> [[f64; 3]; 3] {
    let scene = compose(text).unwrap_or_else(|error| panic!("{error}"));
    let summary = simulate(&scene, None, |_| Ok(()), |_| ()).unwrap();
    let body = &summary.end.bodies["body"];
    [body.position, body.velocity, body.angular_velocity]
}

const BLOCK: &str = r#"[simulation]
duration = 1.0
step = 1e-3
output_step = 1.0

[bodies.body]
mass = 2.0
inertia = [[0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.5]]
velocity = [3.0, 0.0, 0.0]

[joints.guide]
kind = "prismatic"
first = "ground"
second = "body"
axis = [1.0, 0.0, 0.0]

[forces.rub]
kind = "friction"
joint = "guide"
limit = 4.0
speed = 1e-2
"#;

#[test]
fn a_block_brakes_on_its_guide_and_creeps_where_it_is_pushed() {
    // 2 m/s² from 3 m/s; the smooth passage takes speed² / 2 v² of the friction away
    let [position, velocity, _] = end(BLOCK);
    assert!(
        (velocity[0] - 1.0).abs() < 1e-4 && (position[0] - 2.0).abs() < 1e-4,
        "{position:?} {velocity:?}"
    );
    // pushed by 3 N of the limit's 4 N: it comes to rest, but for 3 / √7 of the speed of the passage
    let pushed = BLOCK
        .replace("duration = 1.0", "duration = 8.0")
        .replace("step = 1e-3", "step = 1e-3\ngravity = [1.5, 0.0, 0.0]");
    let [_, velocity, _] = end(&pushed);
    let creep = 1e-2 * 3.0 / 7.0_f64.sqrt();
    assert!((velocity[0] - creep).abs() < 1e-9, "{velocity:?}, {creep}");
}

const ROTOR: &str = r#"[simulation]
duration = 2.0
step = 1e-2
output_step = 2.0

[bodies.body]
mass = 2.0
inertia = [[0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.5]]

[joints.bearing]
kind = "revolute"
first = "ground"
second = "body"
axis = [0.0, 1.0, 0.0]

[forces.motor]
kind = "actuator"
joint = "bearing"
input = "0.2*t"
gain = 3.0
"#;

#[test]
fn an_actuator_turns_a_rotor_as_its_input_says() {
    // 0.6 t N m on 0.5 kg m²: 0.6 t² rad/s
    let [.., spin] = end(ROTOR);
    assert!((spin[1] - 2.4).abs() < 1e-12, "{spin:?}");
    // 0.6 N m at most: from 1 s on
    let [.., spin] = end(&format!("{ROTOR}limit = 0.6\n"));
    assert!((spin[1] - 1.8).abs() < 1e-12, "{spin:?}");
    // between a point of the ground and one of the body, positive apart: a lever of 0.5 m at right angles
    let line = ROTOR
        .replace("joint = \"bearing\"", "first = \"ground\"\nfirst_position = [0.5, 0.0, 1e6]\nsecond = \"body\"\nsecond_position = [0.5, 0.0, 0.0]\nacts = \"line\"")
        .replace("duration = 2.0", "duration = 0.01");
    let [.., spin] = end(&line);
    // away from a point far above is down: + about y at x = 0.5; the lever turns by less than 1e-6
    let expected = 0.5 * 0.3 * 0.01_f64.powi(2) / 0.5;
    assert!((spin[1] - expected).abs() < 1e-6 * expected, "{spin:?}, {expected}");
}

#[test]
fn tables_of_friction_and_actuators_refuse_what_they_cannot_mean() {
    for (text, from, to, expected) in [
        (
            BLOCK,
            "joint = \"guide\"",
            "joint = \"rail\"",
            "forces.rub.joint: no joint is called `rail`; there are guide",
        ),
        (
            BLOCK,
            "limit = 4.0",
            "limit = -4.0",
            "forces.rub.limit: expected a number that is not negative, found -4",
        ),
        (BLOCK, "speed = 1e-2", "speed = 0.0", "forces.rub.speed: expected a positive speed, found 0"),
        (BLOCK, "speed = 1e-2", "", "forces.rub.speed: expected a number, found nothing"),
        (
            BLOCK,
            "speed = 1e-2",
            "speed = 1e-2\nstiffness = 1.0",
            "nothing: stiffness is for spring, torsion_spring only",
        ),
        (
            BLOCK,
            "joint = \"guide\"",
            "second = \"body\"",
            "forces.rub.acts: expected `about`, `along` or `line`",
        ),
        (
            BLOCK,
            "joint = \"guide\"",
            "joint = \"guide\"\naxis = [1.0, 0.0, 0.0]",
            "nothing: the joint has its own",
        ),
        (
            BLOCK,
            "joint = \"guide\"",
            "",
            "forces.rub.second: expected BODY or BODY.MARKER, or a joint in `joint`",
        ),
        (ROTOR, "input = \"0.2*t\"", "", "forces.motor.input: expected a function of time, found nothing"),
        (ROTOR, "input = \"0.2*t\"", "input = \"0.2*x\"", "forces.motor.input: formula"),
        (ROTOR, "gain = 3.0", "acts = \"round\"", "expected `about`, `along` or `line`, found `round`"),
        (ROTOR, "\"actuator\"", "\"servo\"", "no kind of force is called `servo`"),
    ] {
        assert!(text.contains(from), "{from}");
        let said = compose(&text.replace(from, to)).err().unwrap_or_default();
        assert!(said.contains(expected), "{to}: {said}");
    }
}
