//! Integrators and treatments of constraints by their names in scene files: what goes together, and what is refused.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::path::Path;

use ffrf_host::scene::{Integrator, Scene, SceneError};
use ffrf_host::simulate::{Sample, SavedState, Summary, simulate};

/// Positions of a step that was solved with places to ten digits of their size, one metre, some times over.
const SOLVED: f64 = 1e-8;

/// Rates of residuals that are solved for as well, m/s: the correction above over the step, 5e-4 s, contracted once more.
const SOLVED_RATE: f64 = 1e-7;

/// A slider-crank of rigid bodies with redundant rows, as a scene with these lines on top.
fn slider_crank(simulation: &str) -> String {
    format!(
        r#"[simulation]
duration = 0.2
{simulation}
gravity = [0.0, -9.81, 0.0]
output_step = 0.02
[bodies.crank]
mass = 0.5
center_of_mass = [0.1, 0.0, 0.0]
inertia = [[1e-3, 0.0, 0.0], [0.0, 1e-3, 0.0], [0.0, 0.0, 1e-3]]
angular_velocity = [0.0, 0.0, 10.0]
markers.PIN = [0.2, 0.0, 0.0]
[bodies.rod]
mass = 0.5
center_of_mass = [0.2, 0.0, 0.0]
inertia = [[5e-3, 0.0, 0.0], [0.0, 5e-3, 0.0], [0.0, 0.0, 5e-3]]
position = [0.2, 0.0, 0.0]
angular_velocity = [0.0, 0.0, -5.0]
velocity = [0.0, 2.0, 0.0]
markers.END = [0.4, 0.0, 0.0]
[bodies.slider]
mass = 0.3
inertia = [[1e-3, 0.0, 0.0], [0.0, 1e-3, 0.0], [0.0, 0.0, 1e-3]]
position = [0.6, 0.0, 0.0]
[joints.main]
kind = "revolute"
first = "ground"
second = "crank"
[joints.big_end]
kind = "revolute"
first = "crank.PIN"
second = "rod"
[joints.small_end]
kind = "revolute"
first = "rod.END"
second = "slider"
[joints.guide]
kind = "prismatic"
first = "ground"
second = "slider"
axis = [1.0, 0.0, 0.0]
"#
    )
}

fn scene(folder: &Path, text: &str) -> Result<Scene, SceneError> {
    let path = folder.join("scene.toml");
    std::fs::write(&path, text).unwrap();
    Scene::read(&path)
}

fn run(scene: &Scene, from: Option<&SavedState>) -> (Vec<Sample>, Summary) {
    let mut samples = Vec::new();
    let keep = |sample: &Sample| {
        samples.push(sample.clone());
        Ok(())
    };
    let summary = simulate(scene, from, keep, |_| ()).unwrap_or_else(|error| panic!("{error}"));
    (samples, summary)
}

fn refusal(simulation: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    match scene(folder.path(), &slider_crank(simulation)) {
        Ok(_) => panic!("accepted: {simulation}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn every_integrator_runs_with_each_of_its_treatments() {
    let folder = tempfile::tempdir().unwrap();
    let end = |simulation: &str| {
        let (samples, summary) = run(&scene(folder.path(), &slider_crank(simulation)).unwrap(), None);
        (samples.last().unwrap().values.clone(), summary.advance)
    };
    let (reference, _) = end("tolerance = 1e-11");
    for (name, integrator) in Integrator::ALL {
        for treatment in integrator.treatments() {
            let simulation = format!("step = 5e-4\nintegrator = \"{name}\"\nconstraints = \"{treatment}\"");
            let (found, advance) = end(&simulation);
            let [crank, rod, slider] = [0, 1, 2].map(|body| {
                let at = 13 * body;
                (0..3).map(|axis| (found[at + axis] - reference[at + axis]).abs()).fold(0.0, f64::max)
            });
            eprintln!(
                "{name}, {treatment}: off by {crank:.1e}, {rod:.1e}, {slider:.1e} m, drift {:.1e} {:.1e}, iterations {}",
                advance.drift.position, advance.drift.velocity, advance.iterations
            );
            // a fourth of the way in two turns: order one in h ω = 0.005
            assert!(crank.max(rod).max(slider) < 2e-2, "{name}, {treatment}");
            if ["index3", "ggl"].contains(treatment) {
                assert!(advance.drift.position < SOLVED, "{name}, {treatment}: {:e}", advance.drift.position);
            }
            if *treatment == "ggl" {
                assert!(advance.drift.velocity < SOLVED_RATE, "{name}: {:e}", advance.drift.velocity);
            }
        }
    }
}

#[test]
fn what_does_not_go_together_is_refused_with_both_keys() {
    let expected = [
        (
            "step = 1e-3\nintegrator = \"rk4\"\nconstraints = \"ggl\"",
            "simulation.constraints: expected projection or baumgarte with `integrator = \"rk4\"`, found `ggl`",
        ),
        (
            "step = 1e-3\nconstraints = \"index3\"",
            "simulation.constraints: expected projection or baumgarte with `integrator = \"rk4\"`, found `index3`",
        ),
        (
            "step = 1e-3\nintegrator = \"rk4\"\nrho_infinity = 0.5",
            "simulation.rho_infinity: expected nothing: only `integrator = \"generalized_alpha\"` has it, found a value \
             with `integrator = \"rk4\"`",
        ),
        (
            "step = 1e-3\nintegrator = \"generalized_alpha\"\nrho_infinity = 1.5",
            "simulation.rho_infinity: expected a number from 0 to 1, found 1.5",
        ),
        (
            "tolerance = 1e-6\nintegrator = \"generalized_alpha\"",
            "simulation.tolerance: expected `step` with a fixed-step integrator, or `dopri5`, found generalized_alpha",
        ),
    ];
    for (simulation, message) in expected {
        assert_eq!(refusal(simulation), message);
    }
    for (name, _) in Integrator::ALL {
        let all = refusal("step = 1e-3\nintegrator = \"euler\"");
        assert!(all.contains(name), "{name} in {all}");
    }
}

#[test]
fn a_run_of_generalised_alpha_continued_is_the_run_itself() {
    let folder = tempfile::tempdir().unwrap();
    let simulation = "step = 1e-3\nintegrator = \"generalized_alpha\"\nrho_infinity = 0.6";
    let whole = scene(folder.path(), &slider_crank(simulation)).unwrap();
    let half = slider_crank(simulation).replace("duration = 0.2", "duration = 0.1");
    let half = scene(folder.path(), &half).unwrap();
    let saved = serde_json::to_string(&run(&half, None).1.end).unwrap();
    let (samples, _) = run(&whole, None);
    let (rest, _) = run(&whole, Some(&serde_json::from_str(&saved).unwrap()));
    assert_eq!(samples.last(), rest.last());
}
