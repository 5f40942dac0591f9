//! The sources in C, compiled and called by the names of their functions, against the instances of the library.
#![allow(unsafe_code)] // the other side of the border

use std::ffi::{c_int, c_void};
use std::path::Path;

use ffrf_fmu::description::Fmi;
use ffrf_fmu::{Instance, Role};
use ffrf_test_kit::scene_text::with_step;

use crate::in_c::{InC, compiled, compiled_with};
use crate::library::{MESSAGES, function, instantiate};
use crate::scenes::{ROTOR, Unpacked, known};

/// What C may differ by from the library after each step, in units in the last place of the largest number of a kind (states,
/// sensors, energies): both sum in other orders, and stiff modes and redundant rows multiply round-off by what they are large.
const PLACES: f64 = 10.0;

/// What drifts may differ by, in units in the last place of the largest number of the state: they are round-off themselves.
const DRIFT: f64 = 64.0;

/// Numbers of a kind, one after the other among the columns: how many are states, sensors, and energies with drifts.
fn kinds(scene: &Unpacked) -> [usize; 2] {
    let count = |is: fn(&Role) -> bool| scene.model.variables.iter().filter(|one| is(&one.role)).count();
    let sensors = count(|role| matches!(role, Role::Output(_)));
    [count(|role| matches!(role, Role::Local(_))) - OBSERVED, sensors]
}

/// Energies and drifts.
const OBSERVED: usize = 5;
const ENERGIES: usize = 3;

/// Of an energy: what first moments and the like that are zero but for round-off (1e-15 of the largest of their kind) add to it;
/// the generator takes them for the zeros they stand for.
const DROPPED: f64 = 1e-12;

/// Of a sensor, in units in the last place: the round-off of one evaluation of accelerations and reactions, sums of larger forces
/// of stiff modes.
const SENSED: f64 = 100.0;

/// The same where dampers of 4e4 N s/m answer to the last place of velocities, and reactions are sums of their forces.
const SENSED_BEHIND_DAMPERS: f64 = 1e4;
/// The same on stiff modes, where the desktop lets bodies stand on their joints with the ground and C holds them by rows: round-off of
/// another kind, enlarged by the stiffness.
const SENSED_ON_STIFF_MODES: f64 = 2e4;

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |largest, number| f64::max(largest, number.abs()))
}

/// What C and the library show after so many steps.
struct Seen {
    found: Vec<f64>,
    expected: Vec<f64>,
    steps: f64,
}

impl Seen {
    fn now(scene: &Unpacked, c: &InC, library: &mut Instance, steps: f64) -> Self {
        let columns = scene.columns();
        let expected = columns.iter().map(|column| library.get(*column).unwrap()).collect();
        Self { found: c.get(&columns), expected, steps }
    }
}

/// How far C is from the library, in units in the last place of the largest number of a kind for each step.
fn places(scene: &Unpacked, seen: &[Seen], sensed: f64) -> f64 {
    let [states, sensors] = kinds(scene);
    let (mut worst, mut first) = (0.0, 0);
    for (count, once) in [(states, 0.0), (sensors, sensed * f64::EPSILON), (ENERGIES, DROPPED)] {
        let of_kind = first..first + count;
        first += count;
        let size = seen.iter().map(|one| largest(&one.expected[of_kind.clone()])).fold(0.0, f64::max);
        for Seen { found, expected, steps } in seen {
            let pairs = found[of_kind.clone()].iter().zip(&expected[of_kind.clone()]);
            let apart = pairs.fold(0.0, |apart, (a, b)| f64::max(apart, (a - b).abs())) - once * size;
            if apart > 0.0 {
                worst = f64::max(worst, apart / (f64::EPSILON * size * steps));
            }
        }
    }
    for Seen { found, expected, .. } in seen {
        assert!(found.iter().all(|number| number.is_finite()));
        let size = largest(&expected[..states]).max(1.0);
        for (a, b) in found[first..].iter().zip(&expected[first..]) {
            assert!((a - b).abs() <= DRIFT * f64::EPSILON * size, "drift {a:e}, expected {b:e}");
        }
    }
    worst
}

/// Both go on side by side; what both show at each communication point.
fn race(scene: &Unpacked, c: &InC, library: &mut Instance, size: f64, points: u32, steps: f64) -> Vec<Seen> {
    let mut seen = vec![Seen::now(scene, c, library, 1.0)];
    for point in 0..points {
        let from = f64::from(point) * size;
        assert_eq!(c.step(from, size), 0, "{:?}", MESSAGES.take());
        library.step(from, size).unwrap();
        seen.push(Seen::now(scene, c, library, f64::from(point + 1) * steps));
    }
    seen
}

/// Scenes of every way to step that C has, with their communication step (s) and how many of their own steps that takes.
fn scenes() -> Vec<(&'static str, Unpacked, f64, f64)> {
    let folder = known("");
    let scene = |name: &str, integrator: &str, step: f64| {
        Unpacked::of_text(&with_step(&folder.join(name), integrator, step))
    };
    let every = |integrator: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/generated_code/every_joint.toml");
        Unpacked::of_text(&with_step(&path, integrator, 1.0 / 4096.0))
    };
    let step = 1.0 / 1024.0;
    vec![
        ("double pendulum", scene("double_pendulum.toml", "rk4", step), 2.5 * step, 3.0),
        ("slider-crank", scene("slider_crank.toml", "linearly_implicit", step / 16.0), step / 10.0, 3.0),
        ("four-bar", scene("four_bar.toml", "symplectic_euler", step), step, 1.0),
        ("governor", scene("governor.toml", "linearly_implicit_euler", step), 1.5 * step, 2.0),
        ("every joint, explicit", every("rk4"), step / 4.0, 1.0),
        ("every joint, implicit", every("linearly_implicit"), step, 4.0),
    ]
}

#[test]
fn sources_in_c_move_as_the_library() {
    for (name, scene, size, steps) in scenes() {
        for (compiler, library, token) in compiled(&scene, Fmi::Three) {
            let c = InC::begun(library, &token);
            let mut instance = scene.begun();
            let sensed = match name {
                "governor" => SENSED_BEHIND_DAMPERS,
                "slider-crank" => SENSED_ON_STIFF_MODES,
                _ => SENSED,
            };
            let seen = race(&scene, &c, &mut instance, size, 40, steps);
            let apart = places(&scene, &seen, sensed);
            eprintln!("{name}, {compiler}: {apart:.3} units in the last place a step");
            assert!(apart <= PLACES, "{name}, {compiler}: {apart}");
        }
    }
}

/// A scene whose joints and forces take what they can from the initial state.
const TAKING: &str = "
[simulation]
duration = 1.0
step = 1e-3
gravity = [0.5, 0.25, -9.75]

[bodies.arm]
mass = 1.5
center_of_mass = [0.1, -0.2, 0.15]
inertia = [[0.02, 0.001, 0.0], [0.001, 0.03, 0.002], [0.0, 0.002, 0.025]]
markers.END = [0.3, 0.2, -0.1]

[bodies.tip]
mass = 0.5
inertia = [[0.02, 0.001, 0.0], [0.001, 0.03, 0.002], [0.0, 0.002, 0.025]]
position = [0.4, 0.3, 0.0]
angular_velocity = [0.5, 0.0, 0.25]

[bodies.ball]
mass = 0.75
inertia = [[0.02, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, 0.02]]
position = [1.0, 0.5, 0.25]
markers.LUG = [0.0, 0.0, 0.1]

[bodies.cart]
mass = 1.0
inertia = [[0.02, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, 0.02]]
position = [2.0, 0.0, 0.0]
velocity = [0.0, 0.6, 0.8]

[joints.base]
kind = \"revolute\"
first = \"ground\"
second = \"arm\"
axis = [0.0, 0.6, 0.8]

[joints.cross]
kind = \"universal\"
first = \"arm.END\"
second = \"tip\"
second_position = [-0.1, -0.1, -0.1]
axis = [0.0, 0.6, 0.8]

[joints.rope]
kind = \"distance\"
first = \"tip\"
second = \"ball\"

[joints.rail]
kind = \"cylindrical\"
first = \"ground\"
first_position = [2.0, 0.0, 0.0]
second = \"cart\"
axis = [0.0, 0.6, 0.8]
drive = { angle = [0.25, 0.5] }

[forces.coil]
kind = \"torsion_spring\"
second = \"arm\"
axis = [0.0, 0.6, 0.8]
stiffness = 3.0
damping = 0.25

[forces.cord]
kind = \"spring\"
first = \"ball.LUG\"
second = \"cart\"
stiffness = 40.0
damping = 2.0

[forces.spring]
kind = \"spring\"
first = \"arm.END\"
second = \"ball\"
stiffness = 10.0
rest = 0.5

[forces.mount]
kind = \"bushing\"
first = \"cart\"
second = \"ball.LUG\"
stiffness_matrix = [3.0, 4.0, 5.0, 0.5, 0.25, 0.125]

[forces.brake]
kind = \"friction\"
joint = \"base\"
limit = 0.5
speed = 0.125
damping = 0.25

[forces.pull]
kind = \"force\"
second = \"ball\"
value = [1.0, 2.0, 3.0]

[forces.motor]
kind = \"actuator\"
joint = \"rail\"
acts = \"along\"
input = [0.75, -2.0, 30.0]
gain = 4.0
limit = 50.0

[sensors.turn]
kind = \"angle\"
of = \"base\"

[sensors.bearing]
kind = \"reaction_force\"
of = \"cross\"
";

/// Parameters of [`TAKING`] with other values, of every kind.
const CHANGED: [(&str, f64); 24] = [
    ("simulation.gravity.y", -1.0),
    ("simulation.step", 5e-4),
    ("bodies.arm.orientation.y", 0.125),
    ("bodies.arm.angular_velocity.z", 0.25),
    ("bodies.tip.orientation.x", 0.25),
    ("bodies.tip.position.x", 0.4),
    ("bodies.tip.angular_velocity.y", -0.25),
    ("bodies.ball.position.x", 1.125),
    ("bodies.ball.velocity.z", 0.5),
    ("bodies.cart.orientation.z", 0.0625),
    ("bodies.cart.velocity.y", 0.3),
    ("forces.coil.stiffness", 5.0),
    ("forces.coil.damping", 0.5),
    ("forces.cord.stiffness", 30.0),
    ("forces.spring.rest", 0.25),
    ("forces.spring.stiffness", 12.0),
    ("forces.mount.stiffness_matrix.2", 8.0),
    ("forces.mount.stiffness_matrix.6", 0.25),
    ("forces.brake.limit", 0.25),
    ("forces.brake.speed", 0.25),
    ("forces.brake.damping", 0.125),
    ("forces.pull.value.z", -2.0),
    ("forces.motor.gain", -3.0),
    ("forces.motor.limit", 1.5),
];

#[test]
fn parameters_in_c_do_what_they_do_in_the_library() {
    for integrator in ["rk4", "linearly_implicit"] {
        let text = TAKING.replace("step = 1e-3", &format!("step = 1e-3\nintegrator = \"{integrator}\""));
        let scene = Unpacked::of_text(&text);
        for (compiler, library, token) in compiled(&scene, Fmi::Three) {
            let c = InC::new(library, &token);
            let mut instance = scene.instance();
            for (name, value) in CHANGED {
                let reference = scene.reference(name);
                assert_eq!(c.set(reference, value), 0, "{name}");
                instance.set(reference, value).unwrap();
                assert_eq!(c.get(&[reference]), [value]);
            }
            assert_eq!((c.enter(0.5), c.exit()), (0, 0), "{:?}", MESSAGES.take());
            instance.enter_initialisation(0.5).unwrap();
            instance.exit_initialisation().unwrap();
            let mut seen = Vec::new();
            for point in 0..40 {
                let from = 0.5 + f64::from(point) * 1.25e-3;
                seen.push(Seen::now(&scene, &c, &mut instance, f64::from(1 + 3 * point)));
                assert_eq!(c.step(from, 1.25e-3), 0, "{:?}", MESSAGES.take());
                instance.step(from, 1.25e-3).unwrap();
            }
            let worst = places(&scene, &seen, SENSED);
            eprintln!("parameters, {integrator}, {compiler}: {worst:.3} units in the last place a step");
            assert!(worst <= PLACES, "{integrator}, {compiler}: {worst}");
        }
    }
}

#[test]
fn inputs_in_c_act_from_where_they_are_set() {
    let scene = Unpacked::of_text(&ROTOR.replace("[2.0]", "[60.0, 30.0]"));
    let input = scene.reference("motor.input");
    for (_, library, token) in compiled(&scene, Fmi::Three) {
        let c = InC::begun(library, &token);
        let mut instance = scene.begun();
        let mut seen = Vec::new();
        for point in 0..30 {
            let from = f64::from(point) * 0.0123;
            // not set: the scene's own function of time
            assert_eq!(c.get(&[input]), [instance.get(input).unwrap()]);
            if point > 5 && point % 4 == 0 {
                let value = from * 40.0 - 3.0;
                assert_eq!(c.set(input, value), 0);
                instance.set(input, value).unwrap();
            }
            assert_eq!(c.step(from, 0.0123), 0);
            instance.step(from, 0.0123).unwrap();
            seen.push(Seen::now(&scene, &c, &mut instance, f64::from(2 * point + 2)));
        }
        let apart = places(&scene, &seen, SENSED);
        assert!(apart <= PLACES, "{apart}");
        // the angle has been counted over turns
        assert!(c.get(&[scene.reference("turn")])[0] > 7.0);
    }
}

#[test]
fn states_in_c_are_taken_up_again_bit_by_bit() {
    let scene = Unpacked::of_text(TAKING);
    let columns = scene.columns();
    let (input, gain) = (scene.reference("motor.input"), scene.reference("forces.motor.gain"));
    for (_, library, token) in compiled(&scene, Fmi::Three) {
        let one = InC::new(library, &token);
        assert_eq!(one.set(gain, 3.0), 0);
        assert_eq!((one.enter(0.0), one.exit()), (0, 0));
        let other = InC::begun(library, &token);
        let run = |c: &InC, points: std::ops::Range<u32>| -> Vec<Vec<u64>> {
            points
                .map(|point| {
                    let from = f64::from(point) * 2.3e-3;
                    if point % 3 == 0 {
                        assert_eq!(c.set(input, from * 40.0 - 0.1), 0);
                    }
                    assert_eq!(c.step(from, 2.3e-3), 0, "{:?}", MESSAGES.take());
                    c.bits(&columns)
                })
                .collect()
        };
        run(&one, 0..5);
        // instances do not know each other
        run(&other, 0..3);
        let (now, bytes) = (one.bits(&columns), one.bytes());
        let there = run(&one, 5..15);
        assert_eq!(one.take_up(&bytes), 0);
        assert_eq!(one.bits(&columns), now);
        assert_eq!(one.bytes(), bytes);
        assert_eq!(run(&one, 5..15), there);
        // in another instance, with other parameters, and in one that has never begun
        for c in [other, InC::new(library, &token)] {
            assert_eq!(c.take_up(&bytes), 0);
            assert_eq!(c.get(&[gain]), [3.0]);
            assert_eq!(c.bits(&columns), now);
            assert_eq!(run(&c, 5..15), there);
            assert_eq!(c.take_up(&bytes[..bytes.len() - 8]), 3);
            assert_eq!(c.take_up(&[b"x", &bytes[1..]].concat()), 3);
        }
        // and the beginning again
        let reset = function!(library, "fmi3Reset", fn(*mut c_void) -> c_int);
        // SAFETY: an instance that is not freed.
        assert_eq!(unsafe { reset(one.instance) }, 0);
        assert_eq!(one.get(&[gain]), [4.0]);
        assert_eq!((one.enter(0.0), one.exit()), (0, 0));
        assert_eq!(one.bits(&columns), InC::begun(library, &token).bits(&columns));
        MESSAGES.take();
    }
}

#[test]
fn what_cannot_be_done_in_c_is_said() {
    let scene = Unpacked::of_text(TAKING);
    for (_, library, token) in compiled(&scene, Fmi::Three) {
        MESSAGES.take();
        assert!(instantiate(&library, "another", "/nowhere".into()).is_null());
        let c = InC::new(library, &token);
        let speed = scene.reference("forces.brake.speed");
        assert_eq!(c.step(0.0, 1e-3), 3);
        assert_eq!(c.set(scene.reference("turn"), 1.0), 3);
        assert_eq!(c.set(9999, 1.0), 3);
        assert_eq!(c.set(speed, f64::NAN), 3);
        assert_eq!((c.set(speed, 0.0), c.enter(0.0), c.exit()), (0, 0, 3));
        assert_eq!((c.set(speed, 0.125), c.set(scene.reference("forces.cord.damping"), -1.0)), (0, 0));
        assert_eq!(c.exit(), 3);
        assert_eq!(c.set(scene.reference("forces.cord.damping"), 1.0), 0);
        assert_eq!(c.set(scene.reference("simulation.step"), 0.0), 0);
        assert_eq!(c.exit(), 3);
        assert_eq!((c.set(scene.reference("simulation.step"), 1e-3), c.exit()), (0, 0));
        assert_eq!(c.set(speed, 1.0), 3);
        assert_eq!(c.step(0.5, 1e-3), 3);
        assert_eq!(c.step(0.0, 0.0), 3);
        let expected = [
            "another token was given",
            "a step is not allowed: the instance is instantiated, it must be in step mode",
            "`turn` cannot be set: it is what the simulation computes",
            "value reference 9999: expected one of 0 to",
            "`forces.brake.speed`: expected a finite number",
            "`forces.brake.speed`: expected a number that is positive, found 0",
            "`forces.cord.damping`: expected a number that is not negative, found -1",
            "`simulation.step`: expected a positive step, found 0",
            "`forces.brake.speed` cannot be set: parameters are fixed once the simulation has begun",
            "a step of 0.001 s from t = 0.5 s: expected a positive step from t = 0 s",
            "a step of 0 s from t = 0 s: expected a positive step from t = 0 s",
        ];
        let messages = MESSAGES.take();
        for (found, expected) in messages.iter().zip(expected) {
            assert!(found.starts_with("3: ") && found.contains(expected), "{messages:#?}");
        }
        assert_eq!(messages.len(), expected.len(), "{messages:#?}");
        // a step after which joints cannot be met again leaves the instance where it was
        let wild = InC::new(c.library, &token);
        assert_eq!(wild.set(scene.reference("simulation.step"), 0.5), 0);
        assert_eq!(wild.set(scene.reference("bodies.arm.angular_velocity.x"), 50.0), 0);
        assert_eq!((wild.enter(0.0), wild.exit()), (0, 0));
        let before = wild.bits(&scene.columns());
        assert_eq!(wild.step(0.0, 1.5), 3);
        assert_eq!(wild.bits(&scene.columns()), before);
        let messages = MESSAGES.take();
        assert!(messages[0].contains("the step is too large"), "{messages:?}");
    }
}

#[test]
fn every_function_of_the_standards_is_there_in_c() {
    let scene = Unpacked::of_text(ROTOR);
    for (fmi, prefix, names) in
        [(Fmi::Three, "fmi3", crate::library::FMI3), (Fmi::Two, "fmi2", crate::library::FMI2)]
    {
        for (_, library, _) in compiled(&scene, fmi) {
            for name in names.split_whitespace() {
                library.find(&format!("{prefix}{name}"));
            }
        }
    }
}

#[test]
fn functions_in_c_have_a_name_before_theirs_if_that_is_asked_for() {
    let scene = Unpacked::of_text(ROTOR);
    for (fmi, option, name) in [
        (Fmi::Three, "-DFMI3_FUNCTION_PREFIX=one_", "one_fmi3DoStep"),
        (Fmi::Two, "-DFMI2_FUNCTION_PREFIX=one_", "one_fmi2DoStep"),
    ] {
        for (_, library, _) in compiled_with(&scene, fmi, &[option]) {
            library.find(name);
        }
    }
}

#[test]
fn what_c_does_not_have_is_refused_by_its_name() {
    for (from, to, said) in [
        ("step = 1e-2", "tolerance = 1e-6", "integrator"),
        ("step = 1e-2", "step = 1e-2\nintegrator = \"generalized_alpha\"", "generalized_alpha"),
        ("[2.0]", "\"sin(t)\"", "forces.motor.input"),
        ("", "", "event"),
    ] {
        let text = match said {
            "event" => format!("{ROTOR}\n[events.quarter]\nsensor = \"turn\"\nvalue = 0.05\n"),
            _ => ROTOR.replace(from, to),
        };
        assert_ne!(text, ROTOR);
        let error = Unpacked::of_text(&text).model.c_sources(Fmi::Three, "part").unwrap_err().to_string();
        assert!(error.contains(said) && error.contains("C"), "{error}");
    }
}
