//! `ffrf export fmu` as a user runs it: FMUs that FMPy validates, simulates and compares with `ffrf simulate`.
//!
//! FMPy is installed into a folder of the build if python3 and the index of its packages are there; else that is said, and
//! the test passes.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

fn ffrf(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ffrf")).args(arguments).output().unwrap()
}

fn scene(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(name).display().to_string()
}

/// The version of FMPy that the test was written with.
const FMPY: &str = "fmpy==0.3.32";
/// What FMPy compiles sources with, if the system has none.
const CMAKE: &str = "cmake";

/// A python with FMPy, installed once for all tests, which run side by side.
fn python() -> Option<PathBuf> {
    static PYTHON: OnceLock<Option<PathBuf>> = OnceLock::new();
    PYTHON.get_or_init(installed).clone()
}

fn installed() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fmpy");
    let python = folder.join("bin/python3");
    let runs = |command: &mut Command| command.output().is_ok_and(|output| output.status.success());
    if runs(Command::new(&python).args(["-c", "import fmpy"])) {
        return Some(python);
    }
    let made = runs(Command::new("python3").args(["-m", "venv", "--clear"]).arg(&folder))
        && runs(Command::new(&python).args(["-m", "pip", "install", "--quiet", FMPY, CMAKE]));
    if !made {
        eprintln!("SKIPPED: {FMPY} could not be installed; no FMU was validated");
        return None;
    }
    Some(python)
}

/// A scene for these tests: shorter than those of `models/scenes`, beside the models that it names.
fn shortened(folder: &Path, name: &str, changes: &[(&str, &str)]) -> String {
    let mut text = std::fs::read_to_string(scene(name)).unwrap();
    for (from, to) in changes {
        assert!(text.contains(from), "{name} has no {from}");
        text = text.replace(from, to);
    }
    // beside `models`, one folder up, as the scene says
    let beside = folder.join("scenes");
    std::fs::create_dir_all(&beside).unwrap();
    std::fs::copy(scene("../conrod.ffrf.json"), folder.join("conrod.ffrf.json")).unwrap();
    let path = beside.join(name);
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

#[test]
fn fmus_are_valid_and_do_what_simulate_does() {
    let Some(python) = python() else { return };
    let folder = tempfile::tempdir().unwrap();
    let crank = shortened(folder.path(), "slider_crank.toml", &[("duration = 0.02", "duration = 0.002")]);
    let pendulum =
        shortened(folder.path(), "flexible_pendulum.toml", &[("duration = 0.5", "duration = 0.05")]);
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/commands/fmu.py");
    for path in [crank, pendulum, scene("rotor_run_up.toml"), scene("double_pendulum.toml")] {
        let samples = folder.path().join("samples.csv").display().to_string();
        assert!(ffrf(&["simulate", &path, "-o", &samples]).status.success());
        for version in ["3", "2"] {
            let fmu = folder.path().join("part.fmu").display().to_string();
            let run = ffrf(&["export", "fmu", &path, "--fmi", version, "-o", &fmu]);
            assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
            let run = Command::new(&python).arg(&script).args([&fmu, &samples]).output().unwrap();
            let text =
                [run.stdout, run.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
            assert!(run.status.success(), "{path}, FMI {version}: {text}");
            assert!(text.contains("variables are the same"), "{text}");
        }
    }
}

/// What an FMU of C sources may be off after each step, in units in the last place of the largest state, sensor or energy: C
/// sums in another order, and stiff modes and redundant rows multiply round-off by what they are large.
const PLACES: &str = "10";

#[test]
fn fmus_of_c_sources_do_what_simulate_does() {
    let Some(python) = python() else { return };
    if Command::new("cc").arg("--version").output().is_err() {
        eprintln!("SKIPPED: no C compiler here; no FMU of C sources was simulated");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let crank = shortened(folder.path(), "slider_crank.toml", &[("duration = 0.02", "duration = 0.002")]);
    let pendulum =
        shortened(folder.path(), "flexible_pendulum.toml", &[("duration = 0.5", "duration = 0.05")]);
    let double = shortened(
        folder.path(),
        "double_pendulum.toml",
        &[("tolerance = 1e-9", "step = 1e-3\nintegrator = \"rk4\"")],
    );
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/commands/fmu_c.py");
    for path in [crank, pendulum, double] {
        let samples = folder.path().join("samples.csv").display().to_string();
        assert!(ffrf(&["simulate", &path, "-o", &samples]).status.success());
        let text = std::fs::read_to_string(&path).unwrap();
        // without the comment behind it
        let step = text.lines().find_map(|line| line.strip_prefix("step = ")?.split_whitespace().next());
        let step = step.unwrap();
        for version in ["3", "2"] {
            let fmu = folder.path().join("part.fmu").display().to_string();
            let run = ffrf(&["export", "fmu", &path, "--c-sources", "--fmi", version, "-o", &fmu]);
            assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
            let bin = python.parent().unwrap();
            let paths = std::env::join_paths(
                std::iter::once(bin.to_owned())
                    .chain(std::env::split_paths(&std::env::var_os("PATH").unwrap())),
            );
            let run = Command::new(&python)
                .arg(&script)
                .args([&fmu, &samples, step, PLACES])
                .env("PATH", paths.unwrap())
                .output()
                .unwrap();
            let text =
                [run.stdout, run.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
            assert!(run.status.success(), "{path}, FMI {version}: {text}");
            assert!(text.contains("units in the last place a step"), "{text}");
            for line in text.lines().filter(|line| line.contains("SKIPPED") || line.contains("place a step"))
            {
                eprintln!("{line}");
            }
        }
    }
}

#[test]
fn an_fmu_of_c_sources_holds_them_and_is_the_same_every_time() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part.fmu");
    let name = path.display().to_string();
    let export = |version: &str| {
        let options = ["--c-sources", "--compiler", "none", "--fmi", version, "-o", &name];
        let run = ffrf(&[&["export", "fmu", &scene("slider_crank.toml")], &options[..]].concat());
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        let report = String::from_utf8(run.stdout).unwrap();
        assert!(report.contains("no binary: no compiler was found or asked for"), "{report}");
        std::fs::read(&path).unwrap()
    };
    for (version, description) in [("3", &["sources/buildDescription.xml"][..]), ("2", &[])] {
        let bytes = export(version);
        assert_eq!(bytes, export(version));
        let archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).unwrap();
        let names: Vec<String> = archive.file_names().map(|name| name.unwrap().into_owned()).collect();
        let sources = ["sources/part_slider_crank.c", "sources/fmu.c", "sources/part_slider_crank.h"];
        assert_eq!(names, [&["modelDescription.xml"], &sources[..], description].concat());
    }
}

#[test]
fn scenes_that_c_does_not_have_are_refused_with_the_way_out() {
    let folder = tempfile::tempdir().unwrap();
    let fmu = folder.path().join("part.fmu");
    let run = ffrf(&[
        "export",
        "fmu",
        &scene("double_pendulum.toml"),
        "--c-sources",
        "-o",
        &fmu.display().to_string(),
    ]);
    assert_eq!(run.status.code(), Some(1));
    let text = String::from_utf8(run.stderr).unwrap();
    assert!(text.contains("simulation.integrator") && text.contains("in generated C"), "{text}");
    assert!(text.contains("without it, an FMU with ffrf's own library simulates every scene"), "{text}");
    assert!(!fmu.exists());
}

#[test]
fn an_fmu_holds_the_scene_and_its_files_and_is_the_same_every_time() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part.fmu");
    let name = path.display().to_string();
    let export = || {
        let run = ffrf(&["export", "fmu", &scene("slider_crank.toml"), "-o", &name]);
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        let report = String::from_utf8(run.stdout).unwrap();
        assert!(
            report.starts_with("inputs: 0, outputs: 9, parameters: 51, other variables: 53\n"),
            "{report}"
        );
        std::fs::read(&path).unwrap()
    };
    let bytes = export();
    assert_eq!(bytes, export());
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).unwrap();
    let names: Vec<String> = archive.file_names().map(|name| name.unwrap().into_owned()).collect();
    let binary = format!(
        "binaries/{}-{}/slider_crank{}",
        std::env::consts::ARCH,
        std::env::consts::OS,
        std::env::consts::DLL_SUFFIX
    );
    assert_eq!(
        names,
        ["modelDescription.xml", &binary, "resources/scene.toml", "resources/up/conrod.ffrf.json"]
    );
    let mut text = String::new();
    archive.by_name("resources/scene.toml").unwrap().read_to_string(&mut text).unwrap();
    assert_eq!(text, std::fs::read_to_string(scene("slider_crank.toml")).unwrap());
}

#[test]
fn a_library_that_is_none_is_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let (library, fmu) = (folder.path().join("lib.so"), folder.path().join("part.fmu"));
    std::fs::write(&library, "no library").unwrap();
    let run = ffrf(&[
        "export",
        "fmu",
        &scene("flexible_pendulum.toml"),
        "-o",
        &fmu.display().to_string(),
        "--library",
        &library.display().to_string(),
    ]);
    assert_eq!(run.status.code(), Some(1));
    let text = String::from_utf8(run.stderr).unwrap();
    assert!(text.contains("lib.so: expected an ffrf-fmu library of version"), "{text}");
    assert!(!fmu.exists());
}
