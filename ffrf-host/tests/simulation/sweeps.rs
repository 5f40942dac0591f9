//! How many sweeps over their stages the steps of Radau's methods take, and how far from solved they leave them.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::path::Path;

use ffrf_host::HostMechanism;
use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;
use ffrf_runtime::mechanism::Constrained;
use ffrf_runtime::{RadauIIA, RadauMemory, Tolerances};

use crate::convergence::problem::States;

/// The connecting rod with eight modes turns at 50 Hz on two stiff spring-dampers, which it does not yet pull at.
const TURNING: &str = "[simulation]\nduration = 1.0\nstep = 1e-4\ngravity = [0.0, 0.0, -9.81]
[bodies.rod]
model = \"../conrod.ffrf.json\"
angular_velocity = [314.0, 0.0, 0.0]
[forces.big]
kind = \"bushing\"
first = \"ground\"
first_position = [-0.04740099151709372, 0.0, 0.0]
second = \"rod.BIG_END\"
stiffness_matrix = [2e8, 2e8, 2e8, 0.0, 0.0, 0.0]
damping_matrix = [2e6, 2e6, 2e6, 0.0, 0.0, 0.0]
[forces.small]
kind = \"bushing\"
first = \"ground\"
first_position = [0.10225900184225423, 0.0, 0.0]
second = \"rod.SMALL_END\"
stiffness_matrix = [0.0, 2e8, 2e8, 0.0, 0.0, 0.0]
damping_matrix = [2e6, 2e6, 2e6, 0.0, 0.0, 0.0]
";

/// Steps of 1e-4 s.
const STEPS: usize = 100;

/// The mean number of sweeps per step, and the largest error of a step over its tolerance (root mean square of all numbers),
/// against a step that is solved to three digits more.
fn sweeps<const S: usize>(
    mechanism: &HostMechanism,
    start: &States,
    method: RadauIIA<S>,
    is_remembered: bool,
) -> (f64, f64) {
    let mut memory = RadauMemory::new();
    let system = Constrained(mechanism);
    let Tolerances { relative, absolute } = method.tolerances;
    let tight = Tolerances { relative: relative * 1e-3, absolute: absolute * 1e-3 };
    let tight = RadauIIA { tolerances: tight, ..method };
    let (mut state, mut sum, mut worst) = (start.clone(), 0, 0.0_f64);
    for k in 0..STEPS {
        let (time, h) = (k as f64 * 1e-4, 1e-4);
        let (next, report) = match is_remembered {
            true => method.step_from(&system, &mut memory, &state, time, h).unwrap(),
            false => method.step(&system, &state, time, h).unwrap(),
        };
        let exact = tight.step(&system, &state, time, h).unwrap().0;
        let errors = state.iter().zip(&next).zip(&exact).flat_map(|((state, next), exact)| {
            let pairs = next.numbers().zip(exact.numbers()).zip(state.numbers());
            pairs.map(|((x, y), size)| ((x - y) / (absolute + relative * size.abs())).powi(2))
        });
        let (squares, count) = errors.fold((0.0, 0.0), |(sum, count), square| (sum + square, count + 1.0));
        worst = worst.max((squares / count).sqrt());
        sum += report.iterations;
        state = next;
    }
    (sum as f64 / STEPS as f64, worst)
}

#[test]
fn radau_steps_on_dampers_of_a_turning_body_take_few_sweeps() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes");
    let scene = Scene::compose(&SceneFile::parse(TURNING).unwrap(), &folder).unwrap();
    let start = scene.assembled().unwrap().0;
    let five = |relative| RadauIIA { tolerances: to(relative), ..RadauIIA::order_five() };
    let seven = |relative| RadauIIA { tolerances: to(relative), ..RadauIIA::order_seven() };
    let mechanism = &scene.mechanism;
    // to 1e-10 without mixing and from stages that all begin at zero: 14.4 and 16.8
    for (name, (mean, worst), most) in [
        ("five to 1e-10", sweeps(mechanism, &start, five(1e-10), false), 13.6),
        ("seven to 1e-10", sweeps(mechanism, &start, seven(1e-10), false), 15.8),
        ("five to 1e-10, remembered", sweeps(mechanism, &start, five(1e-10), true), 12.8),
        ("seven to 1e-10, remembered", sweeps(mechanism, &start, seven(1e-10), true), 14.8),
        // without memory 4.1 and 4.2 sweeps to 1e-5 leave errors of 4.5 and 5.3 times 1e-4; with it those to 1e-4 leave 1.8 and 1.5
        ("five to 1e-4, remembered", sweeps(mechanism, &start, five(1e-4), true), 3.5),
        ("seven to 1e-4, remembered", sweeps(mechanism, &start, seven(1e-4), true), 4.8),
    ] {
        eprintln!("order {name}: {mean} sweeps per step, error at most {worst:.1} tolerances");
        assert!(mean < most, "order {name}: {mean}");
        // what sweeps leave is estimated from two of them, or from those of steps before, for parts that decay and parts that ring
        let allowed = if name.ends_with("remembered") { 3.0 } else { 10.0 };
        assert!(worst < allowed, "order {name}: {worst}");
    }
}

/// The tolerances of a scene.
fn to(relative: f64) -> Tolerances {
    Tolerances { relative, absolute: relative * 0.01 }
}
