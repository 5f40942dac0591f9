//! `ffrf plan` as a user runs it: reasons, calls of the macros, a measurement that confirms, and budgets that nothing keeps.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::path::{Path, PathBuf};

use crate::workbench::{Run, Workbench, run_in};

/// What a plan may exceed its budget by.
const OVER_BUDGET: f64 = 2.0;
/// What is measured may be off from what was predicted by this factor, upwards.
const OVER_PREDICTION: f64 = 2.0;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

/// Runs `ffrf plan` in the folder of the workspace, from where the calls that it prints are to stand.
fn plan(words: &str) -> Run {
    run_in(&root(), ["plan"].into_iter().chain(words.split_whitespace()))
}

/// The number that follows the last `before` in a text.
fn number_after(text: &str, before: &str) -> f64 {
    let rest =
        &text[text.rfind(before).unwrap_or_else(|| panic!("`{before}` is not in: {text}")) + before.len()..];
    let word = rest.split_whitespace().next().unwrap();
    word.trim_end_matches([':', ';', ',']).parse().unwrap_or_else(|_| panic!("`{word}` after `{before}`"))
}

/// Every part of a plan is there, and the measurement confirms it.
#[track_caller]
fn confirm(scene: &Path, error: f64, more: &str) -> String {
    let scene = scene.display();
    let text = plan(&format!("{scene} --error {error} --measure {more}")).succeeded();
    for part in [
        "predicted error",
        "predicted cost",
        "own error",
        "models: their error",
        "integrators:",
        "ffrf::mechanism! {",
    ] {
        assert!(text.contains(part), "{scene}: `{part}` is not in: {text}");
    }
    let measured = number_after(&text, "\nmeasured\n  error ");
    let predicted = number_after(&text, "\npredicted error ");
    assert!(measured <= OVER_BUDGET * error, "{scene}: {measured} of {error}: {text}");
    assert!(measured <= OVER_PREDICTION * predicted, "{scene}: {measured} of {predicted}: {text}");
    text
}

/// The same of a scene with flexible bodies, each of whose modes and terms has a reason.
#[track_caller]
fn check(scene: &Path, error: f64, more: &str) -> String {
    let text = confirm(scene, error, more);
    let scene = scene.display();
    // 'rod 3: 1.2 Hz, ...' and 'rod first_moment: ...'
    let lines_of = |section: &str| -> Vec<&str> {
        let start = text.find(section).unwrap_or_else(|| panic!("{scene}: no `{section}` in: {text}"));
        text[start..].lines().skip(1).take_while(|line| line.starts_with("  ")).collect()
    };
    for section in ["\nmodes: ", "\nterms of the kinetic energy: "] {
        let lines = lines_of(section);
        let lines: Vec<&&str> = lines.iter().filter(|line| !line.trim().is_empty()).collect();
        for line in &lines {
            assert!(
                line.contains(": kept: ")
                    || line.contains(": dropped: ")
                    || line.contains(": kept as far as"),
                "{line}"
            );
        }
    }
    text
}

/// A scene of `models/scenes`, cut short: its reference takes most of a plan.
fn shortened(bench: &Workbench, name: &str, duration: f64) -> PathBuf {
    let text = std::fs::read_to_string(root().join("models/scenes").join(name)).unwrap();
    let lines = text.lines().map(|line| match line.split_once(" = ") {
        Some(("duration", _)) => format!("duration = {duration:?}"),
        _ => line.replace("\"../", &format!("\"{}/", root().join("models").display())),
    });
    bench.write(name, &lines.collect::<Vec<_>>().join("\n"));
    bench.path(name)
}

#[test]
fn plans_of_scenes_of_the_guide_say_why_and_are_confirmed() {
    let bench = Workbench::new();
    let rod = check(&shortened(&bench, "tumbling_rod.toml", 1.0), 1e-3, "");
    // the rod bends by 0.02 mm: rigid is enough, and every mode says so
    assert_eq!(rod.matches("the error without it is").count(), 4, "{rod}");
    assert!(rod.contains("static correction is not worth a mode"), "{rod}");
    // modes come in pairs, and the second pair does not move the disc
    let rotor = check(&shortened(&bench, "flexible_rotor.toml", 0.1), 1e-2, "");
    for (mode, reason) in [(1, ": kept: "), (2, ": kept: "), (3, ": dropped: "), (4, ": dropped: ")] {
        let line = rotor.lines().find(|line| line.starts_with(&format!("  shaft {mode}: ")));
        assert!(line.is_some_and(|line| line.contains(reason)), "{mode}{reason}: {rotor}");
    }
    let crank = root().join("models/scenes/slider_crank.toml");
    let stroke = check(&crank, 1e-4, "--quantity stroke");
    assert!(stroke.contains("dropped modes: how far they move what is asked for"), "{stroke}");
    // the force in the bearing needs the mode along the rod, which the place of the piston does not
    let bearing = check(&crank, 3e-2, "--quantity bearing");
    assert!(bearing.contains("flexible_body!") && bearing.contains(": kept: "), "{bearing}");
}

/// Rigid mechanisms: all that errs are steps and rounding.
#[test]
fn plans_of_rigid_scenes_are_confirmed() {
    for name in ["andrews_squeezer", "bricard", "crane", "double_pendulum", "four_bar"] {
        confirm(&root().join(format!("models/scenes/{name}.toml")), 1e-2, "");
    }
}

/// The beam bends, the part at its tip hardly does: each body has the modes that take part, and the calls of the macros say so.
#[test]
fn each_body_has_the_modes_that_take_part() {
    let bench = Workbench::with_part();
    crate::tradeoff::write_two_bodies(&bench);
    let text = check(&bench.path("scene.toml"), 1e-3, "");
    let chosen = text.lines().nth(2).unwrap();
    assert!(chosen.contains("beam=") && chosen.contains("part="), "{text}");
    let call = |name: &str| {
        let call = &text[text.find(&format!("pub struct {name} {{")).unwrap()..];
        call.lines().find(|line| line.contains("modes: ")).unwrap().trim().to_owned()
    };
    assert_ne!(call("Beam"), call("Part"), "{text}");
    let first = text.lines().find(|line| line.starts_with("  beam 3: ")).unwrap();
    assert!(first.contains(": kept: "), "{text}");
    plan(&format!(
        "{} --time-per-step 1e-3 --operations-per-second 1e7 --step 1e-3",
        bench.path("scene.toml").display()
    ))
    .succeeded();
}

/// Numbers of a JSON value times a factor.
fn scaled(value: &serde_json::Value, factor: f64) -> serde_json::Value {
    match value {
        serde_json::Value::Array(items) => items.iter().map(|item| scaled(item, factor)).collect(),
        other => (factor * other.as_f64().unwrap()).into(),
    }
}

/// Stress stiffness goes where its bound is far below the budget though the other terms of second order must stay; where it is
/// as large as they are, it stays.
#[test]
fn stress_stiffness_is_left_out_where_its_bound_is_far_below_the_budget() {
    let bench = Workbench::new();
    let beam = std::fs::read_to_string(root().join("models/spin_up_beam.ffrf.json")).unwrap();
    let error = 1e-4;
    for (factor, chosen) in [(1e-4, "unstiffened"), (1.0, "full")] {
        let mut model: serde_json::Value = serde_json::from_str(&beam).unwrap();
        for part in ["uniform_load", "linear_load"] {
            let load = &mut model["geometric_stiffness"][part];
            *load = scaled(load, factor);
        }
        bench.write("beam.ffrf.json", &model.to_string());
        bench.write(
            "scene.toml",
            "[simulation]\nduration = 1.0\nstep = 1e-2\ngravity = [0.0, 0.0, -9.81]\noutput_step = 0.05\n\
             [bodies.beam]\nmodel = \"beam.ffrf.json\"\n\
             [joints.hub]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"beam\"\naxis = [0.0, 1.0, 0.0]\n\
             [sensors.tip]\nkind = \"position\"\nof = \"beam.TIP\"\n",
        );
        let text = check(&bench.path("scene.toml"), error, "");
        assert!(text.lines().nth(2).unwrap().contains(&format!(" modes, {chosen}, ")), "{text}");
        // the largest of the bounds, before the brackets
        let term =
            |name: &str| text.lines().find(|line| line.starts_with(&format!("  beam {name}: "))).unwrap();
        let bound = |name: &str| {
            let numbers = term(name).split(": ").nth(1).unwrap().split(" (").next().unwrap();
            numbers.split(", ").map(|number| number.parse::<f64>().unwrap()).fold(0.0, f64::max)
        };
        let stiffening = bound("centrifugal_stiffening").max(bound("linear_acceleration_stiffening"));
        let is_dropped = term("centrifugal_stiffening").contains(": dropped: its bound is below the budget");
        assert_eq!(is_dropped, chosen == "unstiffened", "{text}");
        assert_eq!(stiffening < 0.1 * error, is_dropped, "{stiffening}: {text}");
        assert!(
            bound("rotation_quadratic") > error && term("rotation_quadratic").contains(": kept: "),
            "{text}"
        );
        assert!(text.contains("modes, unstiffened: "), "a candidate: {text}");
    }
}

/// The calls that are printed are those that `tests/mechanisms/planned.rs` compiles and runs.
#[test]
fn the_calls_that_a_plan_prints_are_those_that_are_compiled() {
    let text =
        plan("models/scenes/slider_crank.toml --target cortex-m7 --cycles-per-instruction 1 --quantity stroke --scalar f64")
            .succeeded();
    let begin = text.find("ffrf::flexible_body! {").unwrap();
    let end = text.find("// integrator:").unwrap();
    let golden = root().join("tests/golden/planned_slider_crank.rs");
    let calls =
        format!("// What `ffrf plan` prints; made by the test `plan` of ffrf-cli.\n{}", &text[begin..end]);
    if std::env::var_os("FFRF_UPDATE_GOLDEN").is_some() {
        std::fs::write(&golden, &calls).unwrap();
    }
    let committed = std::fs::read_to_string(&golden).unwrap_or_default();
    assert!(committed == calls, "stale: FFRF_UPDATE_GOLDEN=1 renews {}: {calls}", golden.display());
}

#[test]
fn a_plan_for_a_target_says_what_it_assumes() {
    let scene = "models/scenes/slider_crank.toml --quantity stroke";
    let m7 = plan(&format!("{scene} --target cortex-m7")).succeeded();
    for part in [
        "ticks of 1e-3 s on a cortex-m7 at 4.8e8 Hz",
        "2.4000e5 instructions, at 2 cycles each",
        "instructions in a tick",
        "instructions each, as is usual on this core (`--measure` counts)",
        "% of what there is time for",
        "ffrf::mechanism! {",
    ] {
        assert!(m7.contains(part), "`{part}` is not in: {m7}");
    }
    // double precision is software there, so that single is taken
    let m4 = plan(&format!("{scene} --target cortex-m4f --clock 1.68e9 --share 0.5")).succeeded();
    assert!(m4.contains("scalar: f32"), "{m4}");
    assert!(number_after(&m4, "predicted cost: ") <= 0.5 * 1.68e6 / 2.0, "{m4}");
    plan(&format!("{scene} --target cortex-m4f --clock 1e5"))
        .failed(1, &["no configuration runs", "operations"]);
    plan(&format!("{scene} --target cortex-m7 --integrator generalized_alpha"))
        .failed(1, &["generalized_alpha", "rk4 or linearly_implicit"]);
    plan(&format!("{scene} --target cortex-m7 --tick 10")).failed(1, &["longer than the scene"]);
    plan(&format!("{scene} --target cortex-m7 --share 1.5")).failed(2, &["up to 1"]);
}

/// What belongs to one kind of budget is not silently left out of another.
#[test]
fn what_a_budget_has_no_use_for_is_refused() {
    let scene = "models/scenes/slider_crank.toml";
    let of_a_target = [
        "--tick 1e-3",
        "--clock 1e8",
        "--share 0.5",
        "--cycles-per-instruction 1",
        "--sources .",
        "--folder elsewhere",
    ];
    let others = ["--error 1e-2", "--time-per-step 1e-4 --operations-per-second 1e8"];
    for of_a_target in of_a_target {
        let flag = of_a_target.split(' ').next().unwrap();
        for other in others {
            let budget = other.split(' ').next().unwrap();
            plan(&format!("{scene} {other} {of_a_target}")).failed(2, &[flag, budget, "cannot be used with"]);
        }
        plan(&format!("{scene} {of_a_target}")).failed(2, &["required"]);
    }
    plan(&format!("{scene} --target cortex-m7 --sources .")).failed(2, &["--measure"]);
    for other in ["--operations-per-second 1e8", "--step 1e-3"] {
        let flag = other.split(' ').next().unwrap();
        plan(&format!("{scene} --error 1e-2 {other}")).failed(2, &[flag]);
        plan(&format!("{scene} --target cortex-m7 {other}")).failed(2, &[flag]);
    }
    for pair in [
        "--error 1e-2 --target cortex-m7",
        "--time-per-step 1e-4 --operations-per-second 1e8 --target cortex-m7",
        "--error 1e-2 --time-per-step 1e-4 --operations-per-second 1e8",
    ] {
        plan(&format!("{scene} {pair}")).failed(2, &["cannot be used with"]);
    }
}
