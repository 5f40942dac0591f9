//! Compiled mechanisms against scenes of the same data.

use std::path::Path;

use ffrf::mechanism::{Assembly, Constrained};
use ffrf::{ModalVector, State, System};
use ffrf_host::HostModal;
use ffrf_host::scene::Scene;

use crate::bodies::{BIG_END, Pendulum, Rod, SliderCrank, SliderCrankState, WholeRod};

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
