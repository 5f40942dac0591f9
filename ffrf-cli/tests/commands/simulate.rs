//! `ffrf simulate` as a user runs it: the scenes of `models/scenes`, saved states, refusals.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::path::PathBuf;

use super::program::{ffrf, scene};

/// The columns of a result by name.
fn read(path: &std::path::Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap().split(',').map(str::to_owned).collect();
    (header, lines.map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect())
}

fn column(header: &[String], rows: &[Vec<f64>], name: &str) -> Vec<f64> {
    let place = header.iter().position(|column| column == name).unwrap_or_else(|| panic!("no column {name}"));
    rows.iter().map(|row| row[place]).collect()
}

#[test]
fn the_double_pendulum_keeps_its_energy_and_its_joints() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("out.csv");
    let run = ffrf(&["simulate", &scene("double_pendulum.toml"), "-o", &output.display().to_string()]);
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let (header, rows) = read(&output);
    assert_eq!(rows.len(), 501);
    let energies = ["energy.kinetic", "energy.potential"].map(|name| column(&header, &rows, name));
    let total: Vec<f64> = energies[0].iter().zip(&energies[1]).map(|(t, v)| t + v).collect();
    // the relative tolerance of the scene is 1e-9 per step, over some thousand steps and 20 J
    assert!(total.iter().all(|e| (e - total[0]).abs() < 1e-5), "{total:?}");
    assert!(energies[0].iter().any(|t| *t > 10.0));
    assert!(column(&header, &rows, "drift.position").iter().all(|drift| *drift < 1e-12));
    // an angle that is counted over turns never jumps
    let angles = column(&header, &rows, "elbow_angle");
    assert!(angles.windows(2).all(|pair| (pair[1] - pair[0]).abs() < 1.0));
}

#[test]
fn the_slider_crank_moves_as_its_geometry_says() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("out.csv");
    // a fifth of the scene is enough
    let text = std::fs::read_to_string(scene("slider_crank.toml")).unwrap();
    let text = text.replace("duration = 0.02", "duration = 0.004");
    let text = text.replace("\"../conrod", &format!("\"{}", scene("../conrod")));
    let file = folder.path().join("scene.toml");
    std::fs::write(&file, text).unwrap();
    let (file, output_name) = (file.display().to_string(), output.display().to_string());
    let run = ffrf(&["simulate", &file, "-o", &output_name]);
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let (header, rows) = read(&output);
    let (crank, rod) = (0.04_f64, 0.04740099151709372 + 0.10225900184225423);
    for (t, x) in column(&header, &rows, "t").iter().zip(column(&header, &rows, "stroke.x")) {
        let phi = 100.0 * t;
        let rigid = crank * phi.cos() + (rod * rod - (crank * phi.sin()).powi(2)).sqrt();
        // the rod gives by some micrometres
        assert!((x - rigid).abs() < 2e-5, "t = {t}: {x} and {rigid}");
    }
    let check = ffrf(&["simulate", &file, "--check"]);
    let said = String::from_utf8_lossy(&check.stdout).into_owned();
    // three rigid or flexible bodies, 22 velocities; the drive leaves the modes and the spin of the rod about itself
    assert!(said.contains("velocities: 22"), "{said}");
    assert!(said.contains("redundant"), "{said}");
}

#[test]
fn a_run_continued_from_a_saved_state_is_the_run_itself() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(scene("flexible_pendulum.toml")).unwrap();
    let text = text.replace("\"../conrod", &format!("\"{}", scene("../conrod")));
    let at = |name: &str| folder.path().join(name).display().to_string();
    std::fs::write(at("whole.toml"), text.replace("duration = 0.5", "duration = 0.1")).unwrap();
    std::fs::write(at("half.toml"), text.replace("duration = 0.5", "duration = 0.05")).unwrap();
    for arguments in [
        vec!["simulate", &at("whole.toml"), "-o", &at("whole.csv"), "--save-state", &at("whole.json")],
        vec!["simulate", &at("half.toml"), "-o", &at("half.csv"), "--save-state", &at("half.json")],
        vec![
            "simulate",
            &at("whole.toml"),
            "-o",
            &at("rest.csv"),
            "--load-state",
            &at("half.json"),
            "--save-state",
            &at("rest.json"),
        ],
    ] {
        let run = ffrf(&arguments);
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    }
    let read = |name: &str| std::fs::read_to_string(at(name)).unwrap();
    assert_eq!(read("whole.json"), read("rest.json"));
    assert_eq!(read("whole.csv").lines().last(), read("rest.csv").lines().last());
}

#[test]
fn what_is_wrong_in_a_scene_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(scene("double_pendulum.toml")).unwrap();
    for (from, to, expected) in [
        (
            "kind = \"revolute\"",
            "kind = \"hinge\"",
            ": joints.shoulder.kind: no kind of joint is called `hinge`",
        ),
        ("first = \"upper.END\"", "first = \"upper.TOP\"", "no marker is called `upper.TOP`"),
        (
            "second = \"lower\"",
            "second = \"upper\"",
            "joints.elbow: expected two different ends, found `upper` at both",
        ),
        ("mass = 1.0", "mass = -1.0", "expected a positive mass, found -1"),
        ("duration = 5.0", "duration = nan", "simulation.duration: expected a positive number"),
        ("tolerance = 1e-9", "tolerance = 1e-9\nstep = 1e-3", "either `step` or `tolerance`"),
        ("gravity", "gravitation", "unknown field `gravitation`"),
        ("position = [1.0, 0.0, 0.0]\n", "position = [1.0, 0.0]\n", "bodies.lower"),
        ("of = \"elbow\"", "of = \"knee\"", "no joint is called `knee`"),
        ("[bodies.upper]", "[bodies.upper", "line"),
    ] {
        assert!(text.contains(from), "{from}");
        let file = folder.path().join("scene.toml");
        std::fs::write(&file, text.replacen(from, to, 1)).unwrap();
        let output = folder.path().join("out.csv");
        let run = ffrf(&["simulate", &file.display().to_string(), "-o", &output.display().to_string()]);
        let said = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(run.status.code(), Some(1), "{to}: {said}");
        assert!(said.contains(expected), "{to}: {said}");
        assert!(!output.exists());
    }
}

#[test]
fn a_stiff_spring_is_named_by_the_step_that_it_allows() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("scene.toml");
    // a body of 1 kg on a spring of 1e8 N/m: 2√2 / 1e4 s
    let text = r#"
        [simulation]
        duration = 1.0
        step = 1e-3
        gravity = [0.0, 0.0, -9.81]
        [bodies.bob]
        mass = 1.0
        inertia = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]
        position = [0.0, 0.0, -1.0]
        [joints.guide]
        kind = "prismatic"
        first = "ground"
        second = "bob"
        [forces.spring]
        kind = "spring"
        first = "ground"
        second = "bob"
        stiffness = 1e8
        rest = 1.0
    "#;
    std::fs::write(&file, text).unwrap();
    let output = folder.path().join("out.csv").display().to_string();
    let run = ffrf(&["simulate", &file.display().to_string(), "-o", &output]);
    assert!(!run.status.success());
    let said = String::from_utf8_lossy(&run.stderr);
    assert!(said.contains("the step is too large") || said.contains("grown absurd"), "{said}");
    assert!(said.contains("allow `rk4` steps of at most 2.820e-4 s"), "{said}");
}

#[test]
fn an_explicit_step_that_is_too_long_is_told_the_longest() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(scene("flexible_pendulum.toml")).unwrap();
    let text =
        text.replace("linearly_implicit", "rk4").replace("\"../conrod", &format!("\"{}", scene("../conrod")));
    let file = folder.path().join("scene.toml");
    std::fs::write(&file, text).unwrap();
    let model = ffrf_model::ReducedBody::read(scene("../conrod.ffrf.json")).unwrap();
    let limit = model.largest_stable_step().unwrap();
    let output = folder.path().join("out.csv");
    let run = ffrf(&["simulate", &file.display().to_string(), "-o", &output.display().to_string()]);
    let said = String::from_utf8_lossy(&run.stderr).into_owned();
    assert_eq!(run.status.code(), Some(1), "{said}");
    assert!(said.contains("t = "), "{said}");
    assert!(said.contains(&format!("explicit steps of at most {limit:.3e} s")), "{said}");
}

#[test]
fn every_scene_of_the_repository_passes_its_check() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../models/scenes");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if !name.ends_with(".toml") {
            continue;
        }
        let check = ffrf(&["simulate", &scene(&name), "--check"]);
        let said = String::from_utf8_lossy(&check.stdout).into_owned();
        assert!(check.status.success(), "{name}: {}", String::from_utf8_lossy(&check.stderr));
        assert!(said.contains("degrees of freedom: "), "{name}: {said}");
        // a scene says in its first lines what it is and how it is run
        let text = std::fs::read_to_string(scene(&name)).unwrap();
        let stem = name.trim_end_matches(".toml");
        assert!(text.starts_with("# "), "{name}");
        assert!(text.contains(&format!("# ffrf simulate models/scenes/{name} -o {stem}.csv")), "{name}");
        count += 1;
    }
    assert!(count >= 8, "{count} scenes");
    // the row that lets Bricard's mechanism move is named
    let check = ffrf(&["simulate", &scene("bricard.toml"), "--check"]);
    let said = String::from_utf8_lossy(&check.stdout).into_owned();
    assert!(said.contains("constraint rows: 30, of which redundant: 1\ndegrees of freedom: 1\n"), "{said}");
    assert!(said.contains("  redundant: hinge_6: "), "{said}");
}

#[test]
fn a_run_says_when_a_body_turns_too_fast_for_its_modes() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("out.csv");
    let text = std::fs::read_to_string(scene("spin_up_beam.toml")).unwrap();
    // Without geometric stiffness: the beam of nature stands it.
    let text = text
        .replace("\"../spin_up", &format!("\"{}", scene("../spin_up")))
        .replace("model =", "fidelity = \"unstiffened\"\nmodel =");
    let file = folder.path().join("scene.toml");
    for (duration, warned) in [("duration = 9.0", true), ("duration = 8.0", false)] {
        std::fs::write(&file, text.replace("duration = 20.0", duration)).unwrap();
        let (file, output) = (file.display().to_string(), output.display().to_string());
        let run = ffrf(&["simulate", &file, "-o", &output]);
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        let said = [run.stdout, run.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
        assert_eq!(said.contains("warning: body `beam` turns at 3.8"), warned, "{said}");
    }
}
