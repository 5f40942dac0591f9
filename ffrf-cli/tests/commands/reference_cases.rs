//! Every public reference case by way of the command: reduce, evaluate, verify.
//!
//! Needs `../shared/reference` beside the workspace; says so and passes where that is missing.
#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};

use crate::workbench::Workbench;
use serde_json::{Value, json};

/// Mass matrix, quadratic velocity and energies: `../shared/reference/FORMAT.md`, "suggested tolerance".
const TOLERANCE: f64 = 1e-12;
/// Accelerations: this or [`ACCELERATION_UNCERTAINTIES`] times the case's own uncertainty, see there.
const ACCELERATION_TOLERANCE: f64 = 1e-10;
/// See [`ACCELERATION_TOLERANCE`].
const ACCELERATION_UNCERTAINTIES: f64 = 100.0;

fn reference() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/reference");
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!("SKIPPED: {} is missing; no reference case was checked", folder.display());
    None
}

/// Names of the cases with states, sorted.
fn cases(folder: &Path) -> Vec<String> {
    let names =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut cases: Vec<String> = names
        .filter_map(|name| Some(name.strip_suffix(".json")?.to_owned()))
        .filter(|name| !name.starts_with("traj_"))
        .collect();
    cases.sort();
    assert!(!cases.is_empty(), "{} holds no case", folder.display());
    cases
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

fn rows(value: &Value) -> Vec<Vec<f64>> {
    value.as_array().unwrap().iter().map(numbers).collect()
}

/// Rotation matrix of Euler parameters, scalar first: A = ¼ G Ḡᵀ written out.
fn rotation(theta: &[f64]) -> [[f64; 3]; 3] {
    let (s, x, y, z) = (theta[0], theta[1], theta[2], theta[3]);
    [
        [s * s + x * x - y * y - z * z, 2.0 * (x * y - s * z), 2.0 * (x * z + s * y)],
        [2.0 * (x * y + s * z), s * s - x * x + y * y - z * z, 2.0 * (y * z - s * x)],
        [2.0 * (x * z - s * y), 2.0 * (y * z + s * x), s * s - x * x - y * y + z * z],
    ]
}

/// Aᵀ u
fn to_body(a: &[[f64; 3]; 3], u: &[f64]) -> Vec<f64> {
    (0..3).map(|j| (0..3).map(|i| a[i][j] * u[i]).sum()).collect()
}

/// The state as `ffrf evaluate` wants it.
fn body_resolved(state: &Value) -> Value {
    let a = rotation(&numbers(&state["theta"]));
    let load = numbers(&state["Q_ext"]);
    let force = [to_body(&a, &load[..3]), to_body(&a, &load[3..6]), load[6..].to_vec()].concat();
    json!({
        "q": state["q"], "q_dot": state["q_dot"], "force": force,
        "omega": to_body(&a, &numbers(&state["omega"])), "velocity": to_body(&a, &numbers(&state["v_t"])),
    })
}

/// Translations, rotations, modes.
fn blocks(size: usize) -> [std::ops::Range<usize>; 3] {
    [0..3, 3..6, 6..size]
}

fn largest<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> f64 {
    numbers.into_iter().fold(0.0, |max, number| max.max(number.abs()))
}

#[track_caller]
fn assert_vector(found: &[f64], expected: &[f64], tolerance: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for block in blocks(expected.len()) {
        let scale = largest(&expected[block.clone()]);
        for i in block {
            let deviation = (found[i] - expected[i]).abs();
            assert!(deviation <= tolerance * scale, "{what}[{i}]: {deviation:e}, scale {scale:e}");
        }
    }
}

/// Block by block; the coupling blocks with the modes vanish for free-free modes and are held against `m size`.
#[track_caller]
fn assert_mass_matrix(found: &[Vec<f64>], expected: &[Vec<f64>], coupling: f64, what: &str) {
    let size = expected.len();
    assert_eq!(found.len(), size, "{what}");
    for (a, rows) in blocks(size).into_iter().enumerate() {
        for (b, columns) in blocks(size).into_iter().enumerate() {
            let mut scale = largest(expected[rows.clone()].iter().flat_map(|row| &row[columns.clone()]));
            if (a == 2) != (b == 2) {
                scale = scale.max(coupling);
            }
            for i in rows.clone() {
                for j in columns.clone() {
                    let deviation = (found[i][j] - expected[i][j]).abs();
                    assert!(
                        deviation <= TOLERANCE * scale,
                        "{what}[{i}][{j}]: {deviation:e}, scale {scale:e}"
                    );
                }
            }
        }
    }
}

#[track_caller]
fn assert_scalar(found: &Value, expected: &Value, what: &str) {
    let (found, expected) = (found.as_f64().unwrap(), expected.as_f64().unwrap());
    let deviation = (found - expected).abs();
    assert!(deviation <= TOLERANCE * expected.abs(), "{what}: {found:e} instead of {expected:e}");
}

/// Arguments that name the finite-element data of a case; writes K_ff where the case has no K.
fn fe_arguments(folder: &Path, name: &str, case: &Value, bench: &Workbench) -> (Vec<String>, bool) {
    let file = |file: &str| folder.join("fe").join(name).join(file);
    let text = |path: PathBuf| path.to_str().unwrap().to_owned();
    let mut words =
        vec!["--nodes".to_owned(), text(file("X.txt")), "--mass".to_owned(), text(file("Ms.mtx"))];
    words.extend(["--mode-shapes".to_owned(), text(file("Psi.txt"))]);
    let stiffness = file("K.mtx");
    let has_stiffness = stiffness.exists();
    if has_stiffness {
        words.extend(["--stiffness".to_owned(), text(stiffness)]);
    } else {
        let line = |row: Vec<f64>| row.iter().map(|entry| format!("{entry:e} ")).collect::<String>() + "\n";
        bench.write("K_ff.txt", &rows(&case["invariants"]["K_ff"]).into_iter().map(line).collect::<String>());
    }
    (words, has_stiffness)
}

#[test]
fn reduce_and_evaluate_reproduce_every_case_and_verify_agrees() {
    let Some(folder) = reference() else { return };
    for name in cases(&folder) {
        let case: Value =
            serde_json::from_str(&std::fs::read_to_string(folder.join(format!("{name}.json"))).unwrap())
                .unwrap();
        let bench = Workbench::new();
        let (fe, has_stiffness) = fe_arguments(&folder, &name, &case, &bench);
        let fe: Vec<&str> = fe.iter().map(String::as_str).collect();
        let modal: &[&str] = if has_stiffness { &[] } else { &["--modal-stiffness", "K_ff.txt"] };
        bench.run_words([&["reduce"], &fe[..], modal, &["-o", "body.ffrf.json"]].concat()).succeeded();
        check_states(&bench, &name, &case);
        let said = bench.run_words([&["verify"], &fe[..], &["body.ffrf.json"]].concat()).succeeded();
        assert!(said.contains("verified"), "{said}");
        eprintln!("{name}:\n{said}");
    }
}

fn check_states(bench: &Workbench, name: &str, case: &Value) {
    let states: Vec<&Value> = case["states"].as_array().unwrap().iter().collect();
    let inputs: Vec<Value> = states.iter().map(|state| body_resolved(state)).collect();
    bench.write("states.json", &json!({ "states": inputs }).to_string());
    bench.run("evaluate body.ffrf.json states.json -o out.json").succeeded();
    let out: Value = serde_json::from_str(&bench.read("out.json")).unwrap();
    assert_eq!(out["states"].as_array().unwrap().len(), states.len());
    let coupling = case["invariants"]["m"].as_f64().unwrap() * case["size"].as_f64().unwrap();
    for (index, (expected, found)) in states.iter().zip(out["states"].as_array().unwrap()).enumerate() {
        let what = |quantity: &str| format!("{name}, state {index}: {quantity}");
        let (found_mass, mass) = (rows(&found["mass_matrix"]), rows(&expected["mass_b"]));
        assert_mass_matrix(&found_mass, &mass, coupling, &what("mass matrix"));
        let quadratic = numbers(&found["quadratic_velocity"]);
        assert_vector(&quadratic, &numbers(&expected["qw_b"]), TOLERANCE, &what("quadratic velocity"));
        let uncertainty = expected["acc_uncertainty_rel"].as_f64().unwrap();
        let tolerance = ACCELERATION_TOLERANCE.max(ACCELERATION_UNCERTAINTIES * uncertainty);
        let acceleration = numbers(&found["acceleration"]);
        assert_vector(&acceleration, &numbers(&expected["acc_b"]), tolerance, &what("acceleration"));
        assert_scalar(&found["kinetic_energy"], &expected["kinetic"], &what("kinetic energy"));
        assert_scalar(&found["elastic_energy"], &expected["elastic"], &what("elastic energy"));
    }
}
