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
        Err(error) => without_line(&error),
    }
}

/// The message after its line, which must be one.
fn without_line(error: &SceneError) -> String {
    let SceneError::Line { line, error } = error else { panic!("no line: {error}") };
    assert!(*line > 0);
    error.to_string()
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
        // this mechanism has a loop
        for treatment in integrator.treatments().iter().filter(|treatment| **treatment != "minimal") {
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
            "simulation.constraints: expected projection or baumgarte or minimal with `integrator = \"rk4\"`, found `ggl`",
        ),
        (
            "step = 1e-3\nconstraints = \"index3\"",
            "simulation.constraints: expected projection or baumgarte or minimal with `integrator = \"rk4\"`, found `index3`",
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
            "step = 1e-3\nconstraints = \"minimal\"",
            "simulation.constraints: expected a tree of bodies with `constraints = \"minimal\"`, found joint `big_end`, \
             which closes a loop",
        ),
        (
            "step = 1e-3\nintegrator = \"linearly_implicit\"\nconstraints = \"minimal\"",
            "simulation.constraints: expected projection or baumgarte with `integrator = \"linearly_implicit\"`, found \
             `minimal`",
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

#[test]
fn the_exponential_step_is_refused_where_a_joint_holds_what_modes_move() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/flexible_pendulum.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let model = path.with_file_name("../conrod.ffrf.json");
    let text = text
        .replace("linearly_implicit", "exponential")
        .replace("../conrod.ffrf.json", &model.display().to_string());
    let folder = tempfile::tempdir().unwrap();
    let Err(error) = scene(folder.path(), &text) else { panic!("accepted") };
    assert_eq!(
        without_line(&error),
        "simulation.integrator: expected joints at points that modes do not move, and diagonal modal matrices, with \
         `integrator = \"exponential\"`, found joint `pin`, which holds what modes move"
    );
}

/// A tree with every kind of joint that joint coordinates know, bodies in either order, and one body that flies.
fn tree(simulation: &str) -> String {
    let mut text = format!(
        "[simulation]\nduration = 0.5\ntolerance = 1e-11\n{simulation}\ngravity = [0.5, -9.81, 1.0]\noutput_step = 0.1\n"
    );
    for (k, name) in ["a", "b", "c", "d", "e", "f", "g"].iter().enumerate() {
        let i = 0.02 + 0.003 * k as f64;
        text += &format!(
            "[bodies.{name}]\nmass = {}\ncenter_of_mass = [0.2, 0.05, -0.03]\n\
             inertia = [[{i}, 0.0, 0.0], [0.0, 0.03, 0.0], [0.0, 0.0, 0.025]]\nposition = [{}, 0.1, 0.0]\n\
             angular_velocity = [0.3, {}, 0.5]\nmarkers.END = [0.4, 0.1, 0.0]\n",
            1.0 + 0.1 * k as f64,
            0.4 * k as f64,
            0.2 * k as f64,
        );
    }
    for (name, kind, first, second, axis) in [
        ("j1", "revolute", "ground", "a", "[0.0, 0.3, 1.0]"),
        ("j2", "spherical", "b", "a.END", "[0.0, 0.0, 1.0]"),
        ("j3", "cylindrical", "b.END", "c", "[1.0, 0.2, 0.0]"),
        ("j4", "prismatic", "d", "c.END", "[0.3, 1.0, 0.0]"),
        ("j5", "fixed", "d.END", "e", "[0.0, 0.0, 1.0]"),
        ("j6", "planar", "e.END", "f", "[0.1, 0.2, 1.0]"),
    ] {
        text += &format!(
            "[joints.{name}]\nkind = \"{kind}\"\nfirst = \"{first}\"\nsecond = \"{second}\"\naxis = {axis}\n"
        );
    }
    text
}

#[test]
fn joint_coordinates_give_the_motion_of_absolute_ones() {
    let folder = tempfile::tempdir().unwrap();
    let (absolute, _) = run(&scene(folder.path(), &tree("")).unwrap(), None);
    let (minimal, summary) = run(&scene(folder.path(), &tree("constraints = \"minimal\"")).unwrap(), None);
    assert_eq!(absolute.len(), minimal.len());
    let (mut worst, mut moved) = (0.0_f64, 0.0_f64);
    for (one, other) in absolute.iter().zip(&minimal) {
        for (index, (one, other)) in one.values.iter().zip(&other.values).enumerate() {
            worst = worst.max((one - other).abs());
            moved = moved.max((other - minimal[0].values[index]).abs());
        }
    }
    let drift = &minimal.last().unwrap().values[minimal[0].values.len() - 2..];
    eprintln!("difference {worst:.1e} of {moved:.1}, drift {drift:?}, steps {}", summary.advance.steps);
    // two error-controlled runs at 1e-11 per step
    assert!(worst < 1e-7, "{worst:e}");
    assert!(moved > 1.0);
    assert!(drift[0] < 1e-13 && drift[1] < 1e-12, "{drift:?}");
}

#[test]
fn drives_that_contradict_each_other_are_refused_with_the_joint() {
    let folder = tempfile::tempdir().unwrap();
    let text = |first: &str, second: &str| {
        slider_crank("step = 1e-3")
            .replace(
                "first = \"ground\"\nsecond = \"crank\"\n",
                &format!("first = \"ground\"\nsecond = \"crank\"\ndrive = {{ angle = {first} }}\n"),
            )
            .replace(
                "first = \"crank.PIN\"\nsecond = \"rod\"\n",
                &format!("first = \"crank.PIN\"\nsecond = \"rod\"\ndrive = {{ angle = {second} }}\n"),
            )
    };
    let assembled =
        |first: &str, second: &str| scene(folder.path(), &text(first, second)).unwrap().assembled();
    // a dead centre with both links along x: 10 rad/s of the crank are -15 rad/s between crank and rod
    assert!(assembled("[0.0, 10.0]", "[0.0, -15.0]").is_ok());
    let error = assembled("[0.0, 10.0]", "[0.0, -12.0]").unwrap_err().to_string();
    assert!(
        error.contains("`: no initial velocities meet it") && error.contains("(m/s or rad/s)"),
        "{error}"
    );
    let error = assembled("[0.0, 10.0]", "[0.0, -15.0, 40.0]").unwrap_err().to_string();
    assert!(error.contains("`: no initial accelerations meet it"), "{error}");
}

#[test]
fn implicit_methods_pass_a_singular_position_or_say_that_they_do_not() {
    // the four-bar linkage of the IFToMM library: all bars on one line every 1.6 s or so, where it could go another way
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/four_bar.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let line =
        |key: &str| text.lines().find(|line| line.starts_with(key)).unwrap_or_else(|| panic!("no {key}"));
    for (integrator, constraints, most) in
        [("linearly_implicit", "projection", 5e-3), ("generalized_alpha", "index3", 5e-3)]
    {
        let text = text
            .replace(
                line("step ="),
                &format!("step = 2e-3\nintegrator = \"{integrator}\"\nconstraints = \"{constraints}\""),
            )
            .replace(line("duration ="), "duration = 4.0");
        let scene = scene(folder.path(), &text).unwrap();
        let names = ffrf_host::simulate::header(&scene);
        let (samples, summary) = run(&scene, None);
        let column = |name: &str| names.iter().position(|found| found == name).unwrap() - 1;
        let parts = ["energy.kinetic", "energy.elastic", "energy.potential"].map(column);
        let energy = |sample: &Sample| parts.iter().map(|part| sample.values[*part]).sum::<f64>();
        let error =
            samples.iter().map(|sample| (energy(sample) - energy(&samples[0])).abs()).fold(0.0, f64::max);
        let heights = samples.iter().map(|sample| sample.values[column("tip.y")]);
        let passes = heights.clone().zip(heights.skip(1)).filter(|(one, next)| one * next <= 0.0).count();
        let drift = column("drift.position");
        let drift = samples.iter().map(|sample| sample.values[drift]).fold(0.0, f64::max);
        eprintln!(
            "{integrator}: energy {error:.1e} J, drift {drift:.1e} m, {passes} passes, iterations {}",
            summary.advance.iterations
        );
        assert!(passes >= 2, "{integrator}: {passes}");
        assert!(error < most, "{integrator}: {error:e} J");
        assert!(drift < SOLVED, "{integrator}: {drift:e} m");
    }
    // to round-off the equations cannot be solved where rows become dependent: said, after a bounded number of iterations
    let conserving = text
        .replace(line("step ="), "step = 2e-3\nintegrator = \"energy_momentum\"")
        .replace(line("duration ="), "duration = 4.0");
    let conserving = scene(folder.path(), &conserving).unwrap();
    let refused = simulate(&conserving, None, |_| Ok(()), |_| ()).unwrap_err().to_string();
    assert!(refused.contains("the step is not solved after 30 iterations"), "{refused}");
}

#[test]
fn samples_do_not_change_the_motion() {
    let folder = tempfile::tempdir().unwrap();
    let mut simulations: Vec<String> =
        Integrator::ALL.iter().map(|(name, _)| format!("step = 1e-3\nintegrator = \"{name}\"")).collect();
    simulations.push("tolerance = 1e-9".to_owned());
    for simulation in simulations {
        let runs = ["0.02", "0.0137", "0.2"].map(|output| {
            let text =
                slider_crank(&simulation).replace("output_step = 0.02", &format!("output_step = {output}"));
            run(&scene(folder.path(), &text).unwrap(), None)
        });
        for (samples, summary) in &runs {
            assert_eq!(summary.end, runs[0].1.end, "{simulation}");
            assert_eq!(samples.last(), runs[0].0.last(), "{simulation}");
        }
        // a sample between two steps is as good as one at a step
        let [(coarse, _), (odd, _), _] = &runs;
        let at = |time: f64| {
            let before = coarse.iter().rposition(|sample| sample.time <= time).unwrap();
            let (one, next) = (&coarse[before], &coarse[before + 1]);
            let share = (time - one.time) / (next.time - one.time);
            one.values[0] * (1.0 - share) + next.values[0] * share
        };
        for sample in &odd[1..odd.len() - 1] {
            assert!((sample.values[0] - at(sample.time)).abs() < 1e-2, "{simulation}: {}", sample.time);
        }
    }
}

#[test]
fn a_run_continued_between_two_steps_is_the_run_itself() {
    let folder = tempfile::tempdir().unwrap();
    for simulation in [
        "step = 1e-3",
        "step = 1e-3\nintegrator = \"generalized_alpha\"",
        "step = 1e-3\nintegrator = \"energy_momentum\"",
        "tolerance = 1e-9",
    ] {
        let whole = scene(folder.path(), &slider_crank(simulation)).unwrap();
        let part = slider_crank(simulation).replace("duration = 0.2", "duration = 0.0873");
        let part = scene(folder.path(), &part).unwrap();
        let saved = serde_json::to_string(&run(&part, None).1.end).unwrap();
        let (samples, one) = run(&whole, None);
        let (rest, other) = run(&whole, Some(&serde_json::from_str(&saved).unwrap()));
        assert_eq!(samples.last(), rest.last(), "{simulation}");
        assert_eq!(one.end, other.end, "{simulation}");
        assert_eq!(rest[0].time, 0.0873);
        assert_eq!(rest[1], samples[5], "{simulation}");
    }
}

#[test]
fn steps_longer_than_the_run_are_one_step() {
    let folder = tempfile::tempdir().unwrap();
    let text = slider_crank("step = 1.0\nintegrator = \"linearly_implicit\"")
        .replace("duration = 0.2", "duration = 0.02")
        .replace("output_step = 0.02", "output_step = 0.002");
    let long = scene(folder.path(), &text).unwrap();
    let (samples, summary) = run(&long, None);
    assert_eq!((samples.len(), summary.advance.steps, summary.advance.side_steps), (11, 0, 10));
}
