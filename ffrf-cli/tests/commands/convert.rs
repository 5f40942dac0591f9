//! `ffrf convert`: a body to MBDyn's modal data and back.
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
