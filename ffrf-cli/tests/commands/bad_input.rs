//! Bad input: exit code 1, a message that names the place, and no output file.
#![allow(clippy::unwrap_used)]

use crate::workbench::Workbench;

const REDUCE: &str = "reduce --nodes X.txt --mass M.mtx --stiffness K.mtx -o body.ffrf.json";

/// Runs `reduce` on the part with one file changed; asserts that it fails so and writes nothing.
#[track_caller]
fn refused(file: &str, change: impl Fn(&str) -> String, options: &str, parts: &[&str]) {
    let bench = Workbench::with_part();
    bench.write(file, &change(&bench.read(file)));
    let before = bench.files();
    bench.run(&format!("{REDUCE} {options}")).failed(1, parts);
    assert_eq!(bench.files(), before);
}

fn same(text: &str) -> String {
    text.to_owned()
}

/// Replaces line `number` (from 1).
fn with_line(number: usize, line: &'static str) -> impl Fn(&str) -> String {
    move |text| {
        let lines = text.lines().enumerate().map(|(at, old)| if at + 1 == number { line } else { old });
        lines.collect::<Vec<_>>().join("\n") + "\n"
    }
}

#[test]
fn a_number_that_is_none_is_named_by_file_and_line() {
    refused("K.mtx", with_line(7, "4 1 stiff"), "--modes 3", &["K.mtx:7", "stiff"]);
    refused("M.mtx", with_line(4, "2 1 nan"), "--modes 3", &["M.mtx:4", "nan"]);
    refused("X.txt", with_line(3, "0.2 0.9"), "--modes 3", &["X.txt:3"]);
}

#[test]
fn a_cut_file_is_refused() {
    refused("K.mtx", |text| text[..text.len() / 2].to_owned(), "--modes 3", &["K.mtx"]);
    refused(
        "X.txt",
        |text| text.lines().take(4).collect::<Vec<_>>().join("\n"),
        "--modes 3",
        &["4 nodes", "found 18 rows"],
    );
    refused("M.mtx", |_| String::new(), "--modes 3", &["M.mtx"]);
}

#[test]
fn an_asymmetric_matrix_is_refused() {
    let general = |text: &str| {
        let size = 18;
        let mut full = vec![0.0; size * size];
        for line in text.lines().skip(2) {
            let parts: Vec<f64> = line.split(' ').map(|part| part.parse().unwrap()).collect();
            let (i, j) = (parts[0] as usize - 1, parts[1] as usize - 1);
            full[i * size + j] = parts[2];
            full[j * size + i] = parts[2] * if i == j { 1.0 } else { 1.01 };
        }
        let mut text =
            format!("%%MatrixMarket matrix coordinate real general\n{size} {size} {}\n", size * size);
        for (k, entry) in full.iter().enumerate() {
            text.push_str(&format!("{} {} {entry:e}\n", k / size + 1, k % size + 1));
        }
        text
    };
    refused("K.mtx", general, "--modes 3", &["K.mtx", "symmetric"]);
}

#[test]
fn an_indefinite_stiffness_is_refused() {
    let negative = |text: &str| {
        let (head, entries) = text.split_at(text.match_indices('\n').nth(1).unwrap().0 + 1);
        let negated: String = entries.lines().map(negate).collect();
        format!("{head}{negated}")
    };
    fn negate(line: &str) -> String {
        let mut parts = line.split(' ');
        let (i, j, value) = (parts.next().unwrap(), parts.next().unwrap(), parts.next().unwrap());
        format!("{i} {j} {:e}\n", -value.parse::<f64>().unwrap())
    }
    refused("K.mtx", negative, "--modes 3", &["K.mtx", "indefinite"]);
}

#[test]
fn a_missing_file_is_named() {
    let bench = Workbench::with_part();
    let words = "reduce --nodes Y.txt --mass M.mtx --stiffness K.mtx --modes 2 -o body.ffrf.json";
    bench.run(words).failed(1, &["Y.txt"]);
    bench.run(&format!("{REDUCE} --mode-shapes Psi.txt")).failed(1, &["Psi.txt"]);
    bench
        .run("reduce --nodes X.txt --stiffness K.mtx --modes 2 -o body.ffrf.json")
        .failed(1, &["mass", "--mass"]);
    bench.run("inspect nothing.ffrf.json").failed(1, &["nothing.ffrf.json"]);
    assert_eq!(bench.files(), ["K.mtx", "M.mtx", "X.txt"]);
}

#[test]
fn impossible_wishes_are_refused_with_numbers() {
    refused("X.txt", same, "--modes 13", &["13", "12"]);
    refused("X.txt", same, "--modes 3 --marker tip=17", &["--marker tip", "no node 17", "0 to 5"]);
    refused("X.txt", same, "--modes 3 --clamp ROOT", &["--clamp", "ROOT", "neither a node set"]);
    refused("X.txt", same, "--modes 3 --marker tip=1 --marker tip=2", &["repeated marker names", "tip"]);
    refused("X.txt", same, "--modes 3 --damping-ratio 0.1,0.2", &["damping ratios", "3 modes", "2"]);
    refused("X.txt", same, "--modes 3 --damping-ratio -0.1", &["-0.1"]);
}

#[test]
fn rigid_motion_as_a_mode_is_refused() {
    let bench = Workbench::with_part();
    bench.write("Psi.txt", &"1\n0\n0\n".repeat(6));
    bench
        .run(&format!("{REDUCE} --mode-shapes Psi.txt"))
        .failed(1, &["independence of the modes from rigid motion", "mode 1 is a rigid motion"]);
    let shapes = |row: usize| [(row * row % 7) as f64, (row % 5) as f64, (row * row % 7) as f64 * -2.0];
    let lines: String = (0..18).map(shapes).map(|[a, b, c]| format!("{a} {b} {c}\n")).collect();
    bench.write("Psi.txt", &lines);
    bench.run(&format!("{REDUCE} --mode-shapes Psi.txt")).failed(1, &["mode 3 repeats mode 1"]);
    bench.write("Psi.txt", "1\n2\n3\n");
    bench.run(&format!("{REDUCE} --mode-shapes Psi.txt")).failed(1, &["Psi.txt", "18", "3"]);
    assert_eq!(bench.files(), ["K.mtx", "M.mtx", "Psi.txt", "X.txt"]);
}

#[test]
fn an_old_output_survives_a_failure() {
    let bench = Workbench::with_part();
    bench.write("body.ffrf.json", "precious");
    bench.run(&format!("{REDUCE} --modes 99")).failed(1, &["99"]);
    assert_eq!(bench.read("body.ffrf.json"), "precious");
    let into_nowhere = REDUCE.replace("body.ffrf.json", "nowhere/body.ffrf.json");
    bench.run(&format!("{into_nowhere} --modes 2")).failed(1, &["nowhere"]);
}

#[test]
fn bad_states_are_refused() {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} --modes 1")).succeeded();
    let good = r#"{"states":[{"q":[0],"omega":[0,0,0],"q_dot":[0],"force":[0,0,0,0,0,0,0]}]}"#;
    let cases = [
        ("\"q\":[0]", "\"q\":[0,1]", "states[0].q: expected 1 numbers"),
        ("[0,0,0,0,0,0,0]", "[0,0,0,0,0,0]", "states[0].force: expected 7 numbers"),
        ("\"omega\"", "\"spin\"", "unknown field `spin`"),
        ("\"omega\":[0,0,0],", "", "missing field `omega`"),
        ("]}]}", "]}]", "EOF"),
        ("\"q\":[0]", "\"q\":[1e308]", "states[0]: a result is"),
    ];
    for (from, to, expected) in cases {
        bench.write("states.json", &good.replacen(from, to, 1));
        bench.run("evaluate body.ffrf.json states.json -o out.json").failed(1, &["states.json", expected]);
    }
    assert_eq!(bench.files(), ["K.mtx", "M.mtx", "X.txt", "body.ffrf.json", "states.json"]);
    bench.write("states.json", good);
    bench.run("evaluate body.ffrf.json states.json -o out.json").succeeded();
}

#[test]
fn a_damaged_model_is_refused_with_the_field() {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} --modes 2")).succeeded();
    let good = bench.read("body.ffrf.json");
    let cases = [
        ("\"schema_version\": 1", "\"schema_version\": 2", "schema_version: found 2"),
        ("\"mass\":", "\"weight\":", "inertia.weight: unknown field"),
        ("\"units\": \"unknown\",", "", "units: missing field"),
    ];
    for (from, to, expected) in cases {
        assert!(good.contains(from));
        bench.write("body.ffrf.json", &good.replacen(from, to, 1));
        for command in ["inspect body.ffrf.json", "generate body.ffrf.json -o body.rs"] {
            bench.run(command).failed(1, &["body.ffrf.json", expected]);
        }
    }
    assert!(!bench.files().contains(&"body.rs".to_owned()));
}

/// Every command that reads a model.
const DOORS: [&str; 4] = [
    "inspect body.ffrf.json",
    "generate body.ffrf.json -o out",
    "evaluate body.ffrf.json states.json -o out",
    "verify --nodes X.txt --mass M.mtx --stiffness K.mtx --modes 2 body.ffrf.json",
];

#[test]
fn a_model_that_contradicts_itself_is_refused_at_every_door() {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} --modes 2 --rayleigh 0.3,1e-4")).succeeded();
    let state = r#"{"states":[{"q":[0,0],"omega":[0,0,1],"q_dot":[0,0],"force":[0,0,0,0,0,0,0,0]}]}"#;
    bench.write("states.json", state);
    for door in DOORS {
        bench.run(door).succeeded();
    }
    std::fs::remove_file(bench.path("out")).unwrap();
    let good: serde_json::Value = serde_json::from_str(&bench.read("body.ffrf.json")).unwrap();
    type Fault = fn(&mut serde_json::Value);
    let faults: [(&str, Fault); 7] = [
        ("smallest eigenvalue of K_ff", |body| body["stiffness"][0][0] = (-1.0).into()),
        ("smallest eigenvalue of D_ff", |body| body["damping"][1][1] = (-0.1).into()),
        ("asymmetry of the stiffness K_ff", |body| body["stiffness"][0][1] = 1e3.into()),
        ("asymmetry of the second moment T", |body| body["inertia"]["second_moment"][2][0] = 9.0.into()),
        ("asymmetry of the second moment T", |body| {
            body["inertia"]["second_moment"].as_array_mut().unwrap().swap(0, 1);
        }),
        ("Gram matrix of the inertia invariants", |body| body["inertia"]["mass"] = 5e-324.into()),
        ("mass: ", |body| body["inertia"]["mass"] = 0.0.into()),
    ];
    for (expected, fault) in faults {
        let mut body = good.clone();
        fault(&mut body);
        bench.write("body.ffrf.json", &body.to_string());
        for door in DOORS {
            bench.run(door).failed(1, &["body.ffrf.json", "the body is not consistent", expected]);
        }
    }
    assert!(!bench.files().contains(&"out".to_owned()));
}

#[test]
fn a_number_too_large_for_single_precision_is_named() {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} --modes 2")).succeeded();
    let mut body: serde_json::Value = serde_json::from_str(&bench.read("body.ffrf.json")).unwrap();
    body["stiffness"][1][1] = 2.5e39.into();
    bench.write("body.ffrf.json", &body.to_string());
    bench.run("generate body.ffrf.json").succeeded();
    for flags in ["", "--strategy lanes"] {
        bench
            .run(&format!("generate body.ffrf.json --scalar f32 {flags} -o out.rs"))
            .failed(1, &["body.ffrf.json", "stiffness[1][1]: 2.5e39 is not finite in f32"]);
    }
    assert!(!bench.files().contains(&"out.rs".to_owned()));
}

#[test]
fn modes_are_chosen_from_those_that_are_there() {
    let bench = Workbench::with_part();
    bench.run(&format!("{REDUCE} --modes 4")).succeeded();
    for command in ["generate body.ffrf.json", "inspect body.ffrf.json"] {
        bench.run(&format!("{command} --modes 1..3")).succeeded();
        bench
            .run(&format!("{command} --modes 2..5"))
            .failed(1, &["body.ffrf.json", "mode 4 asked for", "has 4"]);
        bench.run(&format!("{command} --modes 1,1")).failed(1, &["body.ffrf.json", "mode 1 asked for twice"]);
        bench.run(&format!("{command} --modes 3..1")).failed(2, &["`3..1` has no modes"]);
    }
    bench.run("generate --layout damping=zero --modes 0..2").failed(1, &["the number of modes is expected"]);
}
