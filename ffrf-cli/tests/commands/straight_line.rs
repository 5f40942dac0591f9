//! `ffrf generate SCENE` in Rust, as a user runs it: bodies, mechanism and accelerations in one file that compiles.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::path::{Path, PathBuf};

use crate::workbench::{Run, run_in};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

/// Runs a command in a folder of the repository, from where the calls that it prints are to stand.
fn run(folder: &str, words: &str) -> Run {
    run_in(&root().join(folder), words.split_whitespace())
}

/// What is printed is what `tests/mechanisms/straight_line.rs` and `benches/mechanisms` compile and run.
#[test]
fn what_is_printed_is_what_is_compiled() {
    let benches = "benches/mechanisms";
    let committed = [
        ("", "models/scenes/slider_crank.toml --fma off", "tests/golden/straight_slider_crank.rs"),
        ("", "models/scenes/double_pendulum.toml --implicit on", "tests/golden/straight_double_pendulum.rs"),
        (
            benches,
            "scenes/slider_crank_m8.toml --layout-tolerance 1e-10",
            "../../tests/golden/straight_slider_crank_m8.rs",
        ),
        (benches, "scenes/pendulum_n8.toml", "../../tests/golden/straight_pendulum_n8.rs"),
        (benches, "scenes/supported_rotor.toml", "../../tests/golden/straight_supported_rotor.rs"),
        (benches, "scenes/supported_rod.toml", "../../tests/golden/straight_supported_rod.rs"),
    ];
    for (folder, words, file) in committed {
        let text = run(folder, &format!("generate {words}")).succeeded();
        assert_eq!(
            text,
            run(folder, &format!("generate {words}")).succeeded(),
            "{words}: the same text each time"
        );
        let golden = root().join(folder).join(file);
        if std::env::var_os("FFRF_UPDATE_GOLDEN").is_some() {
            std::fs::write(&golden, &text).unwrap();
        }
        let committed = std::fs::read_to_string(&golden).unwrap_or_default();
        assert!(committed == text, "stale: FFRF_UPDATE_GOLDEN=1 renews {}", golden.display());
    }
}

/// Implicit stages cost flash: they are printed where the integrator of the scene has them, or where they are asked for.
#[test]
fn implicit_stages_are_printed_where_they_are_needed() {
    let [explicit, implicit] = ["models/scenes/double_pendulum.toml", "models/scenes/flexible_pendulum.toml"];
    for (words, expected) in [
        (explicit.to_owned(), false),
        (format!("{explicit} --implicit on"), true),
        (implicit.to_owned(), true),
        (format!("{implicit} --implicit off"), false),
    ] {
        let text = run("", &format!("generate {words}")).succeeded();
        let key = text.lines().any(|line| line.trim_start().starts_with("implicit_accelerations: "));
        let function = text.contains("_implicit_accelerations(\n");
        assert_eq!((key, function), (expected, expected), "{words}");
    }
}

#[test]
fn what_straight_line_code_cannot_have_is_refused() {
    let scene = "models/scenes/slider_crank.toml";
    for (words, parts) in [
        (format!("{scene} --scalar f32"), ["--scalar f32", "expected f64"]),
        (format!("{scene} --strategy lanes"), ["--strategy lanes", "expected auto or straight_line"]),
        (format!("{scene} --jacobians"), ["--jacobians", "no Jacobians"]),
        (format!("{scene} --modes 2"), ["--modes", "`modes` of the bodies in the scene"]),
        (format!("{scene} --implicit on --language c"), ["--implicit on", "a scene and --language rust"]),
        (
            "models/conrod.ffrf.json --implicit on".to_owned(),
            ["--implicit on", "a scene and --language rust"],
        ),
        (format!("{scene} --all-motions --language c"), ["--all-motions", "a scene and --language rust"]),
        ("models/scenes/flexible_rotor.toml".to_owned(), ["forces.motor", "expected a scene without it"]),
        ("models/scenes/crane.toml".to_owned(), ["atan2", "a scene without torsion springs"]),
    ] {
        run("", &format!("generate {words}")).failed(1, &parts);
    }
    for (words, parts) in [
        ("models/conrod.ffrf.json", ["--straight-line", "expected a scene"]),
        ("models/scenes/slider_crank.toml --scalar f32", ["--straight-line", "expected --scalar f64"]),
        (
            "models/scenes/slider_crank.toml --scalar f64 --integrator linearly_implicit",
            ["--straight-line", "--integrator rk4"],
        ),
    ] {
        run("", &format!("budget --straight-line --target cortex-m7 {words}")).failed(1, &parts);
    }
}
