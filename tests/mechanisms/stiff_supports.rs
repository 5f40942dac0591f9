//! A flexible rotor on two stiff damped supports, compiled and as a scene: implicit steps have the supports in their matrix.

use std::path::Path;

use ffrf::mechanism::{Constrained, Mechanism};
use ffrf::{
    GeneralisedAlpha, State, mechanism, step_linearly_implicit, step_linearly_implicit_euler, step_rk4,
};
use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;

use crate::bodies::{BIG_END, Rod, SMALL_END};

/// Units: N/m.
const STIFFNESS: f64 = 2e8;
/// Units: N s/m. With the rotor's mass a rate of some 1e7 1/s.
const DAMPING: f64 = 2e6;
/// 50 turns per second. Units: rad/s.
const SPIN: f64 = 314.159;
/// A hundred times and more the step at which explicit methods stop. Units: s.
const STEP: f64 = 1e-4;
/// Of the weight from the axis. Units: m.
const ECCENTRICITY: f64 = 0.02;

mechanism! {
    /// The rod turns about its length, with a weight beside its axis.
    pub struct Rotor {
        bodies: { rod: free Rod, weight: rigid { mass: 0.1, inertia: [1e-5; 3] } },
        gravity: [0.0, 0.0, -9.81],
        joints: { clamp: fixed(rod.SMALL_END, weight.at([0.0, 0.0, -ECCENTRICITY])) },
        forces: {
            left: bushing(ground, rod.BIG_END, stiffness: [STIFFNESS, STIFFNESS, STIFFNESS, 0.0, 0.0, 0.0],
                          damping: [DAMPING, DAMPING, DAMPING, 0.0, 0.0, 0.0]),
            right: bushing(ground.at([SMALL_END - BIG_END, 0.0, 0.0]), rod.SMALL_END,
                           stiffness: [STIFFNESS, STIFFNESS, 0.0, 0.0, 0.0, 0.0],
                           damping: [DAMPING, DAMPING, 0.0, 0.0, 0.0, 0.0], axis: x),
        },
        sensors: { place: position(weight) },
    }
}

fn rotor() -> Mechanism<Rotor> {
    let model = Rotor::new(Rod);
    let mut state = model.at_rest();
    state.rod.position.x = -BIG_END;
    state.weight.position = [SMALL_END - BIG_END, 0.0, ECCENTRICITY].into();
    for body in [&mut state.rod.angular_velocity, &mut state.weight.angular_velocity] {
        body.x = SPIN;
    }
    state.weight.velocity.y = -SPIN * ECCENTRICITY;
    let mut rotor = model.in_motion(state);
    rotor.assemble().unwrap();
    rotor
}

/// The same as a scene.
fn scene() -> Scene {
    let (end, weight, spin) = (-BIG_END, SMALL_END - BIG_END, SPIN);
    let text = format!(
        r#"[simulation]
duration = 0.01
step = 1e-4
integrator = "linearly_implicit"
gravity = [0.0, 0.0, -9.81]
[bodies.rod]
model = "../conrod.ffrf.json"
modes = 4
position = [{end}, 0.0, 0.0]
angular_velocity = [{spin}, 0.0, 0.0]
[bodies.weight]
mass = 0.1
inertia = [[1e-5, 0.0, 0.0], [0.0, 1e-5, 0.0], [0.0, 0.0, 1e-5]]
position = [{weight}, 0.0, {ECCENTRICITY}]
velocity = [0.0, {speed}, 0.0]
angular_velocity = [{spin}, 0.0, 0.0]
[joints.clamp]
kind = "fixed"
first = "rod.SMALL_END"
second = "weight"
second_position = [0.0, 0.0, {below}]
[forces.left]
kind = "bushing"
second = "rod.BIG_END"
stiffness_matrix = [{STIFFNESS}, {STIFFNESS}, {STIFFNESS}, 0.0, 0.0, 0.0]
damping_matrix = [{DAMPING}, {DAMPING}, {DAMPING}, 0.0, 0.0, 0.0]
[forces.right]
kind = "bushing"
first_position = [{weight}, 0.0, 0.0]
second = "rod.SMALL_END"
stiffness_matrix = [0.0, {STIFFNESS}, {STIFFNESS}, 0.0, 0.0, 0.0]
damping_matrix = [0.0, {DAMPING}, {DAMPING}, 0.0, 0.0, 0.0]
"#,
        speed = -SPIN * ECCENTRICITY,
        below = -ECCENTRICITY,
    );
    let file = SceneFile::parse(&text).unwrap();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/scenes");
    Scene::compose(&file, &folder).unwrap_or_else(|error| panic!("{error}"))
}

/// Compiled kernels fuse and order operations differently, and stiff supports make much of little: relative to the largest
/// number of a state.
const SAME: f64 = 1e-9;

#[test]
fn macro_and_scene_agree_on_stiff_supports() {
    let scene = scene();
    let (mut states, _) = scene.assembled().unwrap();
    let mut compiled = rotor();
    let system = Constrained(&scene.mechanism);
    for k in 0..100 {
        states = step_linearly_implicit(&system, &states, k as f64 * STEP, STEP).unwrap().0;
        compiled.step_linearly_implicit(STEP).unwrap();
    }
    let expected: Vec<f64> = states.iter().flat_map(State::numbers).collect();
    let found = compiled.state.to_array();
    let size = expected.iter().fold(0.0_f64, |most, number| most.max(number.abs()));
    let apart = found.iter().zip(&expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    eprintln!("macro and scene: {apart:.1e} of {size:.1e}");
    assert!(apart < SAME * size, "{apart:e} of {size:e}");
}

/// A fifth of a turn. Units: s.
const DURATION: f64 = 4e-3;

/// Deviation of a measured order from the theoretical one: the next power still shows.
const SLOPE: f64 = 0.35;

/// Error at the largest step, of the eccentricity: a turn of 0.03 rad per step in a method of order one.
const LARGEST: f64 = 0.03;

#[test]
fn implicit_steps_follow_the_rotor_where_explicit_ones_stop() {
    let mut explicit = rotor();
    let broken = (0..200).any(|_| explicit.step_with(STEP, step_rk4).is_err());
    assert!(broken, "the supports are stiff");
    let mut fine = rotor();
    for _ in 0..40_000 {
        fine.step_with(DURATION / 40_000.0, step_rk4).unwrap();
    }
    let reference = fine.model.place(&fine.state);
    let mut errors = Vec::new();
    for halving in 0..3 {
        let (steps, step) = (40 << halving, STEP / f64::from(1 << halving));
        let off =
            |rotor: &Mechanism<Rotor>| (rotor.model.place(&rotor.state) - reference).norm() / ECCENTRICITY;
        let mut rosenbrock = rotor();
        let mut euler = rotor();
        for _ in 0..steps {
            rosenbrock.step_linearly_implicit(step).unwrap();
            euler.step_with(step, step_linearly_implicit_euler).unwrap();
        }
        let mut alpha = rotor();
        let method = GeneralisedAlpha::new();
        let mut memory = method.start(&Constrained(&alpha.model), &alpha.state, 0.0, step).unwrap();
        for _ in 0..steps {
            alpha
                .step_with(step, |system, state, time, step| {
                    method.step(system, &mut memory, state, time, step)
                })
                .unwrap();
        }
        errors.push([off(&rosenbrock), off(&euler), off(&alpha)]);
    }
    for (method, (name, order)) in
        [("ROS2", 2.0), ("Euler", 1.0), ("generalised-α", 2.0)].into_iter().enumerate()
    {
        let found = errors.iter().map(|error| error[method]).collect::<Vec<_>>();
        let list: Vec<String> = found.iter().map(|error| format!("{error:.2e}")).collect();
        let slope = (found[1] / found[2]).log2();
        eprintln!("{name}: errors {list:?} of the eccentricity, order {slope:.2}");
        assert!((slope - order).abs() < SLOPE, "{name}: {list:?}");
        assert!(found[0] < LARGEST, "{name}: {list:?}");
    }
}
