//! The way a user goes: reduce, inspect, generate, evaluate, verify.
#![allow(clippy::unwrap_used)]

use crate::workbench::Workbench;
use serde_json::Value;

const REDUCE: &str = "reduce --nodes X.txt --mass M.mtx --stiffness K.mtx -o body.ffrf.json";

fn reduced(options: &str) -> Workbench {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} {options}")).succeeded();
    bench
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

#[test]
fn every_command_explains_itself_with_an_example() {
    let bench = Workbench::new();
    for command in ["reduce", "inspect", "generate", "evaluate", "verify"] {
        let help = bench.run(&format!("{command} --help")).succeeded();
        assert!(help.contains("Example") && help.contains(&format!("ffrf {command} ")), "{help}");
    }
    assert!(bench.run("--version").succeeded().starts_with("ffrf "));
}

#[test]
fn wrong_usage_is_exit_code_2() {
    let bench = Workbench::with_part();
    bench.run("").failed(2, &["Usage"]);
    bench.run("dance").failed(2, &["unrecognized subcommand"]);
    bench.run(&format!("{REDUCE} --modes many")).failed(2, &["invalid value 'many'"]);
    bench.run("reduce --mass M.mtx --modes 3 -o body.ffrf.json").failed(2, &["--nodes"]);
    bench.run(&format!("{REDUCE} --modes 3 --marker tip")).failed(2, &["expected NAME=NODE"]);
    assert_eq!(bench.files(), ["K.mtx", "M.mtx", "X.txt"]);
}

#[test]
fn reduce_says_what_it_found_and_inspect_repeats_it() {
    let bench = Workbench::with_part();
    let words =
        format!("{REDUCE} --modes 4 --title springs --marker tip=5 --marker root=0,1,2 --damping-ratio 0.02");
    let said = bench.run(&words).succeeded();
    // Six masses 1 + n/4 and ten times the coupling 1/8.
    for part in ["6 nodes", "free-free", "12.500000", "inertia", "tip (node 5)", "root (3 nodes)", "ok"] {
        assert!(said.contains(part), "`{part}` is not in: {said}");
    }
    let inspected = bench.run("inspect body.ffrf.json").succeeded();
    let parts = [
        "springs",
        "12.500000",
        "tip",
        "frequency",
        "source",
        "layout",
        "mass_matrix",
        "forward_dynamics",
        "operations",
    ];
    for part in parts {
        assert!(inspected.contains(part), "`{part}` is not in: {inspected}");
    }
    assert_eq!(bench.files(), ["K.mtx", "M.mtx", "X.txt", "body.ffrf.json"]);

    let body = json(&bench.read("body.ffrf.json"));
    assert_eq!(body["title"], "springs");
    assert_eq!(body["markers"][1]["nodes"], json("[0,1,2]"));
    let roles: Vec<&str> = body["provenance"]["sources"]
        .as_array()
        .unwrap()
        .iter()
        .map(|s| s["role"].as_str().unwrap())
        .collect();
    assert_eq!(roles, ["nodes", "mass", "stiffness"]);
}

#[test]
fn inspect_counts_every_kernel_whatever_its_form() {
    for modes in ["1", "4", "9"] {
        let inspected = reduced(&format!("--modes {modes}")).run("inspect body.ffrf.json").succeeded();
        for kernel in
            ["mass_matrix", "quadratic_velocity", "forward_dynamics", "kinetic_energy", "elastic_energy"]
        {
            let counted = |line: &&str| line.trim_start().starts_with(kernel) && line.contains(" operations");
            assert_eq!(inspected.lines().filter(counted).count(), 1, "{modes} modes, {kernel}: {inspected}");
        }
    }
}

#[test]
fn the_same_command_writes_the_same_bytes() {
    let (one, other) = (reduced("--modes 5"), reduced("--modes 5"));
    assert_eq!(one.read("body.ffrf.json"), other.read("body.ffrf.json"));
    let code = |bench: &Workbench| bench.run("generate body.ffrf.json --name Part").succeeded();
    assert_eq!(code(&one), code(&other));
}

#[test]
fn generate_prints_the_code_or_writes_it() {
    let bench = reduced("--modes 3");
    let printed = bench.run("generate body.ffrf.json --name Part --modes 2").succeeded();
    assert!(printed.contains("pub struct Part"), "{printed}");
    bench.run("generate body.ffrf.json --name Part --modes 2 -o part.rs").succeeded();
    assert_eq!(bench.read("part.rs"), printed);
    bench.run("generate body.ffrf.json --modes 9").failed(1, &["body.ffrf.json", "9 modes", "has 3"]);
}

#[test]
fn evaluate_solves_the_equations_of_motion() {
    let bench = reduced("--modes 2 --rayleigh 0.3,1e-4");
    let states = r#"{"states":[
        {"q":[0,0],"omega":[0,0,0],"q_dot":[0,0],"force":[12.5,0,0,0,0,0,0,0]},
        {"q":[0.1,-0.2],"omega":[1,2,-3],"q_dot":[0.5,0.25],"force":[1,2,3,4,5,6,7,8],"velocity":[1,0,0]}]}"#;
    bench.write("states.json", states);
    bench.run("evaluate body.ffrf.json states.json -o out.json").succeeded();
    let text = bench.read("out.json");
    assert_eq!(bench.run("evaluate body.ffrf.json states.json").succeeded(), text);
    let (out, body, states) = (json(&text), json(&bench.read("body.ffrf.json")), json(states));
    let matrix = |rows: &Value| rows.as_array().unwrap().iter().map(numbers).collect::<Vec<_>>();
    let (stiffness, damping) = (matrix(&body["stiffness"]), matrix(&body["damping"]));
    for index in 0..2 {
        let (values, state) = (&out["states"][index], &states["states"][index]);
        let keys: Vec<&String> = values.as_object().unwrap().keys().collect();
        let expected =
            ["acceleration", "elastic_energy", "kinetic_energy", "mass_matrix", "quadratic_velocity"];
        assert_eq!(keys, expected);
        let (mass, quadratic) = (matrix(&values["mass_matrix"]), numbers(&values["quadratic_velocity"]));
        let (acceleration, force) = (numbers(&values["acceleration"]), numbers(&state["force"]));
        let (q, q_dot) = (numbers(&state["q"]), numbers(&state["q_dot"]));
        for i in 0..8 {
            let mut sum: f64 =
                quadratic[i] - force[i] + (0..8).map(|j| mass[i][j] * acceleration[j]).sum::<f64>();
            if i >= 6 {
                sum += (0..2)
                    .map(|nu| stiffness[i - 6][nu] * q[nu] + damping[i - 6][nu] * q_dot[nu])
                    .sum::<f64>();
            }
            // Forces of some hundred newtons, a well-conditioned mass matrix: 1e-16 times 1e4 at worst.
            assert!(sum.abs() < 1e-9, "state {index}, equation {i}: {sum}");
        }
        let elastic: f64 = (0..4).map(|k| 0.5 * q[k / 2] * stiffness[k / 2][k % 2] * q[k % 2]).sum();
        assert!((values["elastic_energy"].as_f64().unwrap() - elastic).abs() <= 1e-12 * elastic);
    }
    let at_rest = &out["states"][0];
    assert_eq!(at_rest["kinetic_energy"], 0.0);
    assert_eq!(numbers(&at_rest["quadratic_velocity"]), [0.0; 8]);
}

#[test]
fn verify_passes_a_sound_body_of_each_kind() {
    let fe = "--nodes X.txt --mass M.mtx --stiffness K.mtx";
    let psi: String =
        (0..18).map(|row| format!("{} {}\n", (row * row % 7) as f64 / 7.0, (row % 5) as f64)).collect();
    for choice in ["--modes 4", "--modes 3 --clamp 0,1,2", "--mode-shapes Psi.txt"] {
        let bench = Workbench::with_part();
        bench.write("Psi.txt", &psi);
        bench.run(&format!("{REDUCE} {choice}")).succeeded();
        let said = bench.run(&format!("verify {fe} {choice} body.ffrf.json")).succeeded();
        for part in
            ["mass matrix, block tt", "gyroscopic forces, block r", "elastic energy", "momentum", "verified"]
        {
            assert!(said.contains(part), "`{part}` is not in: {said}");
        }
    }
}

#[test]
fn verify_fails_a_body_that_is_not_that_of_the_files() {
    let bench = reduced("--modes 3");
    let mut body = json(&bench.read("body.ffrf.json"));
    // More inertia than there is: no contradiction in itself.
    let moment = &mut body["inertia"]["second_moment"][0][0];
    *moment = Value::from(moment.as_f64().unwrap() + 1e-6);
    bench.write("body.ffrf.json", &body.to_string());
    let fe = "--nodes X.txt --mass M.mtx --stiffness K.mtx";
    let words = format!("verify {fe} --modes 3 body.ffrf.json");
    bench.run(&words).failed(1, &["deviation above 1e-12", "gyroscopic forces, block r"]);
    // A tolerance that the damage keeps is kept.
    bench.run(&format!("{words} --tolerance 1e-3")).succeeded();
    bench
        .run(&format!("verify {fe} --modes 2 body.ffrf.json"))
        .failed(1, &["has 3 modes, the mode basis has 2"]);
}
