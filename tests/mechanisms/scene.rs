//! Compiled mechanisms against scenes of the same data.

use std::path::Path;

use ffrf::mechanism::{Assembly, Constrained};
use ffrf::{ModalVector, State, System};
use ffrf_host::HostModal;
use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;

use crate::bodies::{BIG_END, Pendulum, Rod, SMALL_END, SliderCrank, SliderCrankState, WholeRod};
use crate::chain::Chain;
use crate::friction::{Rubbing, swinging};

/// Compiled kernels fuse and order operations differently: each acceleration may differ by this share of the largest.
const ACCELERATIONS: f64 = 1e-12;

fn scene(name: &str) -> Scene {
    Scene::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("models/scenes").join(name)).unwrap()
}

/// The numbers of a state of the host.
fn numbers(states: &[State<HostModal>]) -> Vec<f64> {
    states.iter().flat_map(State::numbers).collect()
}

/// The largest difference, and the largest of the expected.
fn difference(found: &[f64], expected: &[f64]) -> (f64, f64) {
    assert_eq!(found.len(), expected.len());
    found.iter().zip(expected).fold((0.0, 0.0), |(difference, size): (f64, f64), (found, expected)| {
        (difference.max((found - expected).abs()), size.max(expected.abs()))
    })
}

/// The rates of a state as numbers.
fn host_rates(scene: &Scene, state: &Vec<State<HostModal>>) -> Vec<f64> {
    let system = Constrained(&scene.mechanism);
    let rates = system.rates(0.0, state, &scene.mechanism.no_change(state)).unwrap();
    let parts = rates.0.iter().flat_map(|part| {
        let rigid = part.velocity.iter().chain(part.angular_velocity.iter());
        rigid.chain(part.modal_rates.as_slice()).copied().collect::<Vec<_>>()
    });
    parts.collect()
}

macro_rules! rates {
    ($model:expr, $state:expr, $($body:ident)*) => {{
        let rates = Constrained(&$model).rates(0.0, &$state, &$model.no_change(&$state)).unwrap();
        let mut all: Vec<f64> = Vec::new();
        $({
            all.extend(rates.$body.velocity.iter());
            all.extend(rates.$body.angular_velocity.iter());
            all.extend(rates.$body.modal_rates.iter());
        })*
        all
    }};
}

#[test]
fn the_pendulum_is_the_scene() {
    let scene = scene("flexible_pendulum.toml");
    let model = Pendulum::new(WholeRod);
    let mut state = model.at_rest();
    state.rod.position.x = -BIG_END;
    let (host, _) = scene.assembled().unwrap();
    let mut compiled = model.met_in(&state).in_motion(state);
    compiled.assemble().unwrap();
    let assembled = difference(&compiled.state.to_array(), &numbers(&host));
    assert!(assembled.0 < 1e-15, "{assembled:?}");
    let (apart, size) = difference(&rates!(compiled.model, compiled.state, rod), &host_rates(&scene, &host));
    println!("pendulum: {:.1e} of {size:.3e}", apart / size);
    assert!(apart < ACCELERATIONS * size);
}

#[test]
fn the_slider_crank_is_the_scene() {
    let scene = scene("slider_crank.toml");
    let model = SliderCrank::new(Rod);
    let state = SliderCrankState::stretched(&model);
    let mut compiled = model.met_in(&state).in_motion(state);
    compiled.assemble().unwrap();
    let (mut host, _) = scene.assembled().unwrap();
    let names: Vec<&str> = scene.connection_names.iter().map(String::as_str).collect();
    assert_eq!(names, ["main", "main.drive", "big_end", "small_end", "guide"]);
    assert_eq!(SliderCrank::JOINTS, ["main", "motor", "big_end", "small_end", "guide"]);
    let step = 2e-6;
    for k in 0..500 {
        let (next, _) = ffrf::step_rk4(&Constrained(&scene.mechanism), &host, k as f64 * step, step).unwrap();
        host = next;
        compiled.step_rk4(step).unwrap();
    }
    let (apart, size) = difference(&compiled.state.to_array(), &numbers(&host));
    println!("slider-crank after 500 steps: {:.1e} of {size:.3e}", apart / size);
    assert!(apart < 1e-9 * size);
    let (apart, size) =
        difference(&rates!(compiled.model, compiled.state, crank rod piston), &host_rates(&scene, &host));
    println!("its accelerations: {:.1e} of {size:.3e}", apart / size);
    assert!(apart < 1e-6 * size);
}

/// The rods of a chain, one after the other along x, as a scene; `extra` holds what is on top.
fn rods(count: usize, extra: &str) -> Scene {
    let mut text = "[simulation]\nduration = 1.0\nstep = 1e-5\ngravity = [0.0, -9.81, 0.0]\n".to_owned();
    for k in 0..count {
        let x = k as f64 * (SMALL_END - BIG_END) - BIG_END;
        text += &format!(
            "[bodies.link{k}]\nmodel = \"models/conrod.ffrf.json\"\nmodes = 4\nposition = [{x:e}, 0.0, 0.0]\n"
        );
    }
    for k in 0..count {
        let first = if k == 0 { "ground".to_owned() } else { format!("link{}.SMALL_END", k - 1) };
        text += &format!(
            "[joints.hinge{k}]\nkind = \"revolute\"\nfirst = \"{first}\"\nsecond = \"link{k}.BIG_END\"\n"
        );
    }
    let file = SceneFile::parse(&(text + extra)).unwrap();
    Scene::compose(&file, Path::new(env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// Follows both through `steps` steps of `h`: the largest difference of any number, over the largest number, ever.
macro_rules! apart_while_moving {
    ($compiled:ident, $scene:ident, $method:ident, $steps:expr, $h:expr) => {{
        let (mut host, _) = $scene.assembled().unwrap();
        let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
        for k in 0..$steps {
            host = ffrf::$method(&Constrained(&$scene.mechanism), &host, k as f64 * $h, $h).unwrap().0;
            $compiled.step_with($h, ffrf::$method).unwrap();
            let (apart, size) = difference(&$compiled.state.to_array(), &numbers(&host));
            worst = worst.max(apart);
            largest = largest.max(size);
        }
        println!("{}: {:.1e} of {largest:.3e}", stringify!($method), worst / largest);
        worst / largest
    }};
}

/// Numbers of a state over a whole trajectory of some hundred steps, relative to the largest: each step adds round-off of
/// stiff modes, and none of these mechanisms is chaotic within it. Documented in `docs/mechanisms.md`.
const TRAJECTORIES: f64 = 1e-11;

#[test]
fn trajectories_of_a_chain_are_those_of_the_scene() {
    let scene = rods(5, "");
    let model = Chain::new([Rod; 5]);
    let start = || {
        let mut compiled = model.in_motion(model.state_from_array(&{
            let numbers = numbers(&scene.initial);
            std::array::from_fn(|k| numbers[k])
        }));
        compiled.assemble().unwrap();
        compiled
    };
    let mut compiled = start();
    assert!(apart_while_moving!(compiled, scene, step_rk4, 300, 5e-6) < TRAJECTORIES);
    let mut compiled = start();
    assert!(apart_while_moving!(compiled, scene, step_linearly_implicit, 300, 1e-4) < TRAJECTORIES);
    let mut compiled = start();
    assert!(apart_while_moving!(compiled, scene, step_dormand_prince, 100, 5e-6) < TRAJECTORIES);
    let mut compiled = start();
    assert!(apart_while_moving!(compiled, scene, step_symplectic_euler, 300, 2e-6) < TRAJECTORIES);
}

#[test]
fn trajectories_with_friction_are_those_of_the_scene() {
    let friction = "[forces.bearing]\nkind = \"friction\"\njoint = \"hinge0\"\ncoefficient = 0.2\nradius = 0.01\nspeed = 0.05\n\
                    damping = 1e-5\n";
    let mut scene = rods(1, friction);
    let model = Rubbing::new(Rod);
    let mut state = swinging(&model, 3.0);
    let mut compiled = model.in_motion(state);
    compiled.assemble().unwrap();
    state = compiled.state;
    scene.initial[0].angular_velocity.z = 3.0;
    scene.initial[0].velocity.y = -BIG_END * 3.0;
    assert!(apart_while_moving!(compiled, scene, step_rk4, 300, 5e-6) < TRAJECTORIES);
    let mut compiled = model.in_motion(state);
    assert!(apart_while_moving!(compiled, scene, step_linearly_implicit, 300, 1e-4) < TRAJECTORIES);
}

#[test]
fn trajectories_of_the_slider_crank_are_those_of_the_scene() {
    let scene = scene("slider_crank.toml");
    let model = SliderCrank::new(Rod);
    let state = SliderCrankState::stretched(&model);
    let mut compiled = model.met_in(&state).in_motion(state);
    compiled.assemble().unwrap();
    // a loop with redundant rows: what the regularisation leaves of round-off
    assert!(apart_while_moving!(compiled, scene, step_linearly_implicit, 300, 1e-5) < 1e-9);
}
