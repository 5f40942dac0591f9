//! `ffrf tradeoff` and `ffrf plan` of bodies that were read from standard input data and lack terms of second order: the reference
//! has what all bodies hold, and so have sweep and plan.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::collections::BTreeSet;
use std::path::PathBuf;

use crate::convert::to_order_zero;
use crate::workbench::Workbench;

/// What a plan may exceed its budget by.
const OVER_BUDGET: f64 = 2.0;
/// A step of the linearly implicit rule in a tenth of the period of the beam's lowest mode and less: its error is far below.
const EXACT: f64 = 1e-3;

fn models(name: &str) -> String {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../models").join(name).display().to_string()
}

/// The beam of the examples, through standard input data without these matrices' terms of first order: as `lacking.ffrf.json`.
fn beam_without(bench: &Workbench, matrices: &[&str]) {
    let beam = models("spin_up_beam.ffrf.json");
    bench.run_words(["convert", &beam, "-o", "beam.SID_FEM"]).succeeded();
    let text = matrices.iter().fold(bench.read("beam.SID_FEM"), |text, name| to_order_zero(&text, name));
    bench.write("lacking.sid", &text);
    bench.run("convert lacking.sid --units SI -o lacking.ffrf.json").succeeded();
}

/// Beams that swing side by side on hinges, one for each name and model.
fn write_scene(bench: &Workbench, beams: &[(&str, &str)]) {
    let mut text = "[simulation]\nduration = 1.0\nstep = 1e-2\nintegrator = \"linearly_implicit\"\n\
                    gravity = [0.0, 0.0, -9.81]\noutput_step = 0.05\n"
        .to_owned();
    for (name, model) in beams {
        text.push_str(&format!(
            "[bodies.{name}]\nmodel = {model:?}\n\
             [joints.hinge_{name}]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"{name}\"\naxis = [0.0, 1.0, 0.0]\n\
             [sensors.tip_{name}]\nkind = \"position\"\nof = \"{name}.TIP\"\n"
        ));
    }
    bench.write("scene.toml", &text);
}

const GRID: &str = "tradeoff scene.toml -o out --modes=0,4 --scalar=f64 --integrator=linearly_implicit --step=5e-3 \
                    --reference-tolerance=1e-8";

/// The fidelities of a sweep with all modes, and the error of each.
fn swept(bench: &Workbench) -> Vec<(String, f64)> {
    let table = bench.read("out/table.csv");
    let rows = table.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    rows.filter(|row| row[0] == "4").map(|row| (row[1].to_owned(), row[7].parse().unwrap())).collect()
}

/// Sweeps and plans with the terms that are held, the last of `fidelities`; says which; refuses others by name.
#[track_caller]
fn check(bench: &Workbench, fidelities: &[&str], refused: &str, needs: &[&str]) {
    bench.run(&format!("{GRID} --fidelity={refused}")).failed(1, needs);
    // the refusal came before anything was computed or written
    assert!(!bench.path("out").exists());
    let held = fidelities.last().unwrap().replace('+', ", ");
    let said = bench.run(GRID).succeeded();
    let stated = if held == "full" {
        "every term,".to_owned()
    } else {
        format!("every term that all bodies hold ({held}),")
    };
    assert!(said.contains(&stated), "`{stated}` is not in: {said}");
    assert!(bench.read("out/table.txt").contains(&stated) && bench.read("out/report.html").contains(&stated));
    let found = swept(bench);
    let names: BTreeSet<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, fidelities.iter().copied().collect());
    let error = found.iter().find(|(name, _)| name == fidelities.last().unwrap()).unwrap().1;
    assert!(error < EXACT, "{error}: {found:?}");
    // with nothing left to do, as with something: the reference in the folder says what it has
    assert!(bench.run(GRID).succeeded().contains(&stated));

    let budget = 2e-3;
    let text = bench.run(&format!("plan scene.toml --error {budget} --measure")).succeeded();
    assert!(text.contains(&stated) && text.contains("terms of the kinetic energy"), "{text}");
    let measured = text.split("\nmeasured\n  error ").nth(1).unwrap();
    let measured: f64 = measured.split(':').next().unwrap().parse().unwrap();
    assert!(measured <= OVER_BUDGET * budget, "{text}");
    bench.run("plan scene.toml --time-per-step 1e-3 --operations-per-second 1e7 --step 1e-2").succeeded();
}

#[test]
fn a_body_without_terms_of_second_order_is_swept_and_planned_with_those_that_it_has() {
    let bench = Workbench::new();
    beam_without(&bench, &["Gr", "Oe"]);
    write_scene(&bench, &[("beam", "lacking.ffrf.json")]);
    let held = "[first_moment+modal_momentum+rotation_linear+modal_rotation+modal_rotation_deformed+\
                angular_acceleration_stiffening+linear_acceleration_stiffening]";
    let needs = ["bodies.beam.fidelity", "fidelity full cannot be had", "neither `rotation_quadratic`"];
    check(&bench, &["constant", "linear", held], "linear,full", &needs);
    // what the scene itself asks for is refused as ever
    let scene = bench.read("scene.toml").replace("[joints", "fidelity = \"full\"\n[joints");
    bench.write("scene.toml", &scene);
    for command in ["tradeoff scene.toml -o other", "plan scene.toml --error 1e-2"] {
        bench.run(command).failed(1, &needs);
    }
}

#[test]
fn a_body_that_holds_a_sum_of_terms_keeps_or_drops_both() {
    let bench = Workbench::new();
    beam_without(&bench, &["Gr"]);
    write_scene(&bench, &[("beam", "lacking.ffrf.json")]);
    let needs = ["bodies.beam.fidelity", "fidelity unstiffened cannot be had", "only the sum of"];
    check(&bench, &["constant", "linear", "full"], "unstiffened", &needs);
    let text = bench.run("plan scene.toml --error 1e-2").succeeded();
    assert!(text.contains("beam rotation_quadratic with centrifugal_stiffening: "), "{text}");
}

/// What one body lacks no body has: a configuration has one fidelity.
#[test]
fn bodies_that_hold_different_terms_are_swept_with_those_that_all_hold() {
    let bench = Workbench::with_part();
    bench.run("reduce --nodes X.txt --mass M.mtx --stiffness K.mtx --modes 3 --marker TIP=3,4,5 -o part.ffrf.json").succeeded();
    bench.run("convert part.ffrf.json -o part.SID_FEM").succeeded();
    bench.write("part.sid", &to_order_zero(&to_order_zero(&bench.read("part.SID_FEM"), "Gr"), "Oe"));
    bench.run("convert part.sid --units SI -o lacking.ffrf.json").succeeded();
    write_scene(&bench, &[("whole", "part.ffrf.json"), ("poor", "lacking.ffrf.json")]);
    bench.run(&format!("{GRID} --fidelity=full")).failed(1, &["bodies.poor.fidelity", "expected linear"]);
    let said = bench.run(&GRID.replace("0,4", "0,3").replace("5e-3", "1e-3")).succeeded();
    assert!(said.contains("every term that all bodies hold (linear)"), "{said}");
    let table = bench.read("out/table.csv");
    let names: BTreeSet<&str> = table
        .lines()
        .skip(1)
        .filter(|line| line.starts_with("3,"))
        .map(|line| line.split(',').nth(1).unwrap())
        .collect();
    assert_eq!(names, ["constant", "linear"].into());
}
