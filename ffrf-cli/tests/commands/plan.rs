//! `ffrf plan` as a user runs it: reasons, calls of the macros, a measurement that confirms, and budgets that nothing keeps.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::workbench::Run;

/// What a plan may exceed its budget by.
const OVER_BUDGET: f64 = 2.0;
/// What is measured may be off from what was predicted by this factor, upwards.
const OVER_PREDICTION: f64 = 2.0;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

/// Runs `ffrf plan` in the folder of the workspace, from where the calls that it prints are to stand.
fn plan(words: &str) -> Run {
    let output = Command::new(env!("CARGO_BIN_EXE_ffrf"))
        .current_dir(root())
        .arg("plan")
        .args(words.split_whitespace())
        .output()
        .unwrap();
    Run {
        code: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

/// The number that follows the last `before` in a text.
fn number_after(text: &str, before: &str) -> f64 {
    let rest =
        &text[text.rfind(before).unwrap_or_else(|| panic!("`{before}` is not in: {text}")) + before.len()..];
    let word = rest.split_whitespace().next().unwrap();
    word.trim_end_matches([':', ';', ',']).parse().unwrap_or_else(|_| panic!("`{word}` after `{before}`"))
}

/// Every part of a plan is there, each mode and term with a reason, and the measurement confirms it.
#[track_caller]
fn check(scene: &str, error: f64, more: &str) -> String {
    let text = plan(&format!("models/scenes/{scene} --error {error} --measure {more}")).succeeded();
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
    let measured = number_after(&text, "\nmeasured\n  error ");
    let predicted = number_after(&text, "\npredicted error ");
    assert!(measured <= OVER_BUDGET * error, "{scene}: {measured} of {error}: {text}");
    assert!(measured <= OVER_PREDICTION * predicted, "{scene}: {measured} of {predicted}: {text}");
    text
}

#[test]
fn plans_of_the_scenes_of_the_guide_say_why_and_are_confirmed() {
    let rod = check("tumbling_rod.toml", 1e-3, "");
    // the rod bends by 0.02 mm: rigid is enough, and every mode says so
    assert_eq!(rod.matches("the error without it is").count(), 4, "{rod}");
    assert!(rod.contains("static correction is not worth a mode"), "{rod}");
    let stroke = check("slider_crank.toml", 1e-4, "--quantity stroke");
    assert!(stroke.contains("dropped modes: how far they move what is asked for"), "{stroke}");
    // the force in the bearing needs the mode along the rod, which the place of the piston does not
    let bearing = check("slider_crank.toml", 3e-2, "--quantity bearing");
    assert!(bearing.contains("flexible_body!") && bearing.contains(": kept: "), "{bearing}");
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
