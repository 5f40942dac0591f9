//! `ffrf reduce` of a blade with `--geometric-stiffness`, `--stress` and `--damping-bands`, and what the other commands say of it.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::fmt::Write as _;

use ffrf_fe::elements::{Material, brick};
use serde_json::Value;

use crate::workbench::Workbench;

const STEEL: Material = Material { youngs_modulus: 210e9, poisson_ratio: 0.3, density: 7850.0 };

/// Along x, wide in y, thin in z. Units: m.
const EDGES: [f64; 3] = [0.6, 0.05, 0.02];

const REDUCE: &str = "reduce --calculix blade.inp --modes 3 --clamp ROOT -o blade.ffrf.json";
/// Displacements of second order are static solutions of a slender part that is held at one end: of their digits remain about nine.
const VERIFY: &str = "verify --calculix blade.inp --modes 3 --clamp ROOT blade.ffrf.json --tolerance 1e-6";

/// A folder with the deck of a blade and its matrices, as CalculiX leaves them: `blade.inp`, `.mas`, `.sti`, `.dof`.
fn bench() -> Workbench {
    let model = brick(EDGES, [6, 1, 1], &STEEL).unwrap();
    let ids = &model.nodes.ids;
    let mut deck = "*NODE, NSET=ALL\n".to_owned();
    for (id, [x, y, z]) in ids.iter().zip(&model.nodes.positions) {
        let _ = writeln!(deck, "{id}, {x}, {y}, {z}");
    }
    deck.push_str("*ELEMENT, TYPE=C3D8, ELSET=BLADE\n");
    for (index, element) in model.elements.iter().enumerate() {
        let nodes: Vec<String> = element.nodes.iter().map(|&row| ids[row].to_string()).collect();
        let _ = writeln!(deck, "{}, {}", index + 1, nodes.join(", "));
    }
    let set = |name: &str, holds: &dyn Fn([f64; 3]) -> bool| {
        let rows = ids.iter().zip(&model.nodes.positions).filter(|(_, place)| holds(**place));
        let rows: Vec<String> = rows.map(|(id, _)| id.to_string()).collect();
        format!("*NSET, NSET={name}\n{}\n", rows.join(", "))
    };
    let second = 0.5 * EDGES[0] / 6.0 + EDGES[0] / 6.0;
    let near = |x: f64| x > 0.0 && x < second;
    deck.push_str(&set("ROOT", &|[x, ..]| x == 0.0));
    deck.push_str(&set("TOP", &|[x, _, z]| near(x) && z > 0.5 * EDGES[2]));
    deck.push_str(&set("BOTTOM", &|[x, _, z]| near(x) && z < 0.5 * EDGES[2]));
    deck.push_str(
        "*MATERIAL, NAME=STEEL\n*ELASTIC\n210e9, 0.3\n*SOLID SECTION, ELSET=BLADE, MATERIAL=STEEL\n",
    );

    let (mut mass, mut stiffness, mut dofs) = (String::new(), String::new(), String::new());
    for entry in model.mass.triplet_iter().filter(|entry| entry.row <= entry.col) {
        for axis in 1..=3 {
            let _ = writeln!(mass, "{} {} {:e}", 3 * entry.row + axis, 3 * entry.col + axis, entry.val);
        }
    }
    for entry in model.stiffness.iter().flat_map(|matrix| matrix.triplet_iter()) {
        if entry.row <= entry.col {
            let _ = writeln!(stiffness, "{} {} {:e}", entry.row + 1, entry.col + 1, entry.val);
        }
    }
    for id in ids {
        for axis in 1..=3 {
            let _ = writeln!(dofs, "{id}.{axis}");
        }
    }
    let bench = Workbench::new();
    for (ending, text) in [("inp", &deck), ("mas", &mass), ("sti", &stiffness), ("dof", &dofs)] {
        bench.write(&format!("blade.{ending}"), text);
    }
    bench
}

fn body(bench: &Workbench) -> Value {
    serde_json::from_str(&bench.read("blade.ffrf.json")).unwrap()
}

#[test]
fn geometric_stiffness_is_reduced_shown_and_verified() {
    let bench = bench();
    bench.run(REDUCE).succeeded();
    assert!(body(&bench).get("geometric_stiffness").is_none_or(Value::is_null));
    assert!(!bench.run("inspect blade.ffrf.json").succeeded().contains("geometric stiffness"));

    bench.run(&format!("{REDUCE} --geometric-stiffness")).succeeded();
    // A spin about z pulls the blade straight: against bending out of the plane of rotation that stiffens.
    let load = body(&bench)["geometric_stiffness"]["linear_load"][0][0].clone();
    let entry = |i: usize| load[i][i].as_f64().unwrap();
    assert!(entry(0) + entry(1) > 0.0, "{load}");
    let shown = bench.run("inspect blade.ffrf.json").succeeded();
    assert!(shown.contains("geometric stiffness"), "{shown}");
    let verified = bench.run(VERIFY).succeeded();
    assert!(verified.contains("verified"), "{verified}");
    // The constants that the part has; half of its modulus is half of the stress.
    bench.run(&format!("{VERIFY} --elastic 210e9,0.3")).succeeded();
    bench.run(&format!("{VERIFY} --elastic 105e9,0.3")).failed(1, &["deviation above"]);
}

#[test]
fn a_level_without_stiffening_is_smaller() {
    let bench = bench();
    bench.run(&format!("{REDUCE} --geometric-stiffness")).succeeded();
    let code =
        |options: &str| bench.run(&format!("generate blade.ffrf.json --name Blade {options}")).succeeded();
    assert!(code("--fidelity unstiffened").len() < code("").len());
}

#[test]
fn stress_of_bending_has_two_signs() {
    let bench = bench();
    let shown = bench.run(&format!("{REDUCE} --stress top=TOP --stress bottom=BOTTOM")).succeeded();
    for part in ["stress marker", "top (2 nodes)", "bottom (2 nodes)"] {
        assert!(shown.contains(part), "`{part}` is not in: {shown}");
    }
    assert!(bench.run("inspect blade.ffrf.json").succeeded().contains("top (2 nodes)"));
    let body = body(&bench);
    let along = |marker: usize| body["stress_markers"][marker]["stress"][0][0].as_f64().unwrap();
    let (top, bottom) = (along(0), along(1));
    assert!(top != 0.0 && (top + bottom).abs() < 1e-6 * top.abs(), "{top}, {bottom}");
    // Linear in the modulus.
    bench.run(&format!("{REDUCE} --stress top=TOP --elastic 420e9,0.3")).succeeded();
    let doubled = self::body(&bench)["stress_markers"][0]["stress"][0][0].as_f64().unwrap();
    assert!((doubled - 2.0 * top).abs() < 1e-9 * top.abs(), "{doubled}, {top}");
}

#[test]
fn damping_bands_follow_the_frequency() {
    let bench = bench();
    // Of each mode: circular frequency, and damping ratio.
    let modes = |body: &Value| -> Vec<[f64; 2]> {
        let mode = |mode: usize| {
            let diagonal = |key: &str| body[key][mode][mode].as_f64().unwrap();
            let moment = &body["inertia"]["mode_mode_moment"][mode][mode];
            let mass: f64 = (0..3).map(|axis| moment[axis][axis].as_f64().unwrap()).sum();
            let frequency = (diagonal("stiffness") / mass).sqrt();
            [frequency, diagonal("damping") / (2.0 * frequency * mass)]
        };
        (0..3).map(mode).collect()
    };
    bench.run(REDUCE).succeeded();
    let undamped = modes(&body(&bench));
    let between = 0.5 * (undamped[0][0] + undamped[1][0]) / std::f64::consts::TAU;
    bench.run(&format!("{REDUCE} --damping-bands {between}:0.25,inf:0.5")).succeeded();
    for (mode, expected) in modes(&body(&bench)).iter().zip([0.25, 0.5, 0.5]) {
        assert!((mode[1] - expected).abs() < 1e-9, "{mode:?}, not {expected}");
    }
    bench.run(&format!("{REDUCE} --damping-bands")).succeeded();
    for [frequency, ratio] in modes(&body(&bench)) {
        let expected = match frequency / std::f64::consts::TAU {
            hertz if hertz < 100.0 => 0.01,
            hertz if hertz < 1000.0 => 0.1,
            _ => 1.0,
        };
        assert!((ratio - expected).abs() < 1e-9, "{frequency} rad/s: {ratio}, not {expected}");
    }
}

#[test]
fn what_cannot_be_done_is_said() {
    let bench = bench();
    let refused = |options: &str, code: i32, parts: &[&str]| {
        bench.run(&format!("{REDUCE} {options}")).failed(code, parts);
        assert!(!bench.files().contains(&"blade.ffrf.json".to_owned()), "{options}");
    };
    refused("--damping-bands 100", 2, &["100", "HZ:ZETA"]);
    refused("--damping-bands 100:0.1 --damping-ratio 0.1", 2, &["cannot be used with"]);
    refused("--damping-bands 100:0.1,50:0.2,inf:1", 1, &["50"]);
    refused("--stress tip=NOWHERE", 1, &["--stress tip", "NOWHERE"]);
    refused("--geometric-stiffness --elastic 210e9,0.5", 1, &["0.5"]);

    let springs = Workbench::with_part();
    let words = "reduce --nodes X.txt --mass M.mtx --stiffness K.mtx --modes 2 -o body.ffrf.json";
    springs.run(&format!("{words} --geometric-stiffness")).failed(1, &["--geometric-stiffness", "elements"]);
    springs
        .run(&format!("{words} --stress tip=5 --elastic 210e9,0.3"))
        .failed(1, &["--stress tip", "no solid element"]);
}
