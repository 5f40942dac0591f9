//! `ffrf convert`: a body to MBDyn's modal data or to standard input data, and back.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use serde_json::Value;

use crate::workbench::Workbench;

const REDUCE: &str =
    "reduce --nodes X.txt --mass M.mtx --stiffness K.mtx --modes 3 --damping-ratio 0.02 -o body.ffrf.json";

/// Invariants are sums and differences of those that were written.
const ROUND_OFF: f64 = 1e-12;

fn body(bench: &Workbench, file: &str) -> Value {
    serde_json::from_str(&bench.read(file)).unwrap()
}

/// All numbers of a value, in order.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        Value::Object(fields) => fields.values().flat_map(numbers).collect(),
        other => other.as_f64().into_iter().collect(),
    }
}

#[test]
fn a_body_travels_to_mbdyn_and_back() {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} --marker tip=3,4,5 --marker root=0,1,2")).succeeded();
    let said = bench.run("convert body.ffrf.json -o body.fem").succeeded();
    assert!(said.contains("written: body.fem"), "{said}");
    let said = bench.run("convert body.fem --units SI -o again.ffrf.json").succeeded();
    assert!(said.contains("record group 9 differs from that of the invariants by"), "{said}");
    let (first, again) = (body(&bench, "body.ffrf.json"), body(&bench, "again.ffrf.json"));
    assert_eq!((&again["stiffness"], &again["damping"]), (&first["stiffness"], &first["damping"]));
    assert_eq!(again["markers"][0]["name"], "tip");
    assert_eq!(again["markers"][1]["rotation"], first["markers"][1]["rotation"]);
    assert_eq!(again["units"], "m, kg, s, N");
    let (found, expected) = (numbers(&again["inertia"]), numbers(&first["inertia"]));
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(0.0_f64, |most, number| most.max(number.abs()));
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() <= ROUND_OFF * largest, "{found}, {expected}");
    }
    bench.run("inspect again.ffrf.json").succeeded();
}

/// The lines of a file without the terms of first order of a matrix.
pub fn to_order_zero(text: &str, name: &str) -> String {
    let mut inside = false;
    let line = |line: &str| {
        let word = line.trim();
        inside = (inside || word == name) && word != format!("end {name}");
        match inside {
            true if word.starts_with("order") => Some("order = 0\n".to_owned()),
            true if word.starts_with("m1") => None,
            _ => Some(format!("{line}\n")),
        }
    };
    text.lines().filter_map(line).collect()
}

#[test]
fn a_body_travels_as_standard_input_data() {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} --marker tip=3,4,5 --marker root=0,1,2")).succeeded();
    let said = bench.run("convert body.ffrf.json -o body.SID_FEM").succeeded();
    assert!(said.contains("written: body.SID_FEM"), "{said}");
    let said = bench.run("convert body.SID_FEM --units SI -o again.ffrf.json").succeeded();
    assert!(
        said.contains("integrals that the file gives twice differ:") && said.contains("Ge and Cr by 0.0e0"),
        "{said}"
    );
    let (first, again) = (body(&bench, "body.ffrf.json"), body(&bench, "again.ffrf.json"));
    assert_eq!((&again["stiffness"], &again["damping"]), (&first["stiffness"], &first["damping"]));
    for k in [0, 1] {
        for part in ["name", "position", "translation", "rotation"] {
            assert_eq!(again["markers"][k][part], first["markers"][k][part]);
        }
    }
    assert_eq!(again["modes"][0]["frequency_hz"], first["modes"][0]["frequency_hz"]);
    let (found, expected) = (numbers(&again["inertia"]), numbers(&first["inertia"]));
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(0.0_f64, |most, number| most.max(number.abs()));
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() <= ROUND_OFF * largest, "{found}, {expected}");
    }

    // Without terms of second order the body has the fidelities up to linear, and no other.
    let lacking = to_order_zero(&to_order_zero(&bench.read("body.SID_FEM"), "Gr"), "Oe");
    bench.write("lacking.sid", &lacking);
    let said = bench.run("convert lacking.sid -o lacking.ffrf.json").succeeded();
    assert!(said.contains("the body has no terms of second order, and fidelities up to linear"), "{said}");
    bench.run("inspect lacking.ffrf.json --fidelity linear").succeeded();
    assert!(bench.run("inspect lacking.ffrf.json").succeeded().contains("at fidelity linear"));
    bench.run("generate lacking.ffrf.json --fidelity linear -o lacking.rs").succeeded();
    let needs = ["fidelity full cannot be had", "expected linear, constant, rigid, or a list without them"];
    bench.run("generate lacking.ffrf.json -o full.rs").failed(1, &needs);
    bench.run("convert lacking.ffrf.json -o lacking.fem").failed(1, &["does not hold invariant I9"]);
    assert!(!bench.files().contains(&"full.rs".to_owned()));
    let scene = "[simulation]\nduration = 0.01\nstep = 0.001\n[bodies.part]\nmodel = \"lacking.ffrf.json\"\n";
    bench.write("scene.toml", scene);
    bench
        .run("simulate scene.toml -o scene.csv")
        .failed(1, &["bodies.part.fidelity", "fidelity full cannot be had"]);
    bench.write("scene.toml", &format!("{scene}fidelity = \"linear\"\n"));
    bench.run("simulate scene.toml -o scene.csv").succeeded();
}

#[test]
fn what_cannot_be_converted_is_said() {
    let bench = Workbench::with_part();
    bench.run(REDUCE).succeeded();
    bench.run("convert body.ffrf.json -o body.fem").failed(1, &["body.ffrf.json has no marker"]);
    bench
        .run("convert body.ffrf.json -o body.txt")
        .failed(1, &["expected a body (*.ffrf.json) and a file of MBDyn"]);
    bench.write("cut.fem", "** RECORD GROUP 1, HEADER\n REV0 1 1 0 0 0\n");
    bench.run("convert cut.fem -o cut.ffrf.json").failed(1, &["cut.fem:3: expected record group 2"]);
    assert!(!bench.files().contains(&"cut.ffrf.json".to_owned()));
}
