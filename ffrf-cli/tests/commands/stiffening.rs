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
    deck.push_str(&set("TIP", &|[x, ..]| x == EDGES[0]));
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

/// The blade held at its root, pushed at its tip. Units of the step: s.
const PUSHED: &str = r#"
[simulation]
duration = 2e-4
step = 1e-6
integrator = "rk4"
[bodies.blade]
model = "blade.ffrf.json"
modal_coordinates = [3e-3, 1e-3, 0.0]
[joints.clamp]
kind = "fixed"
first = "ground"
second = "blade"
[forces.push]
kind = "force"
second = "blade.tip"
value = [PUSH, 0.0, 0.0]
[sensors.place]
kind = "position"
of = "blade.tip"
[sensors.speed]
kind = "velocity"
of = "blade.tip"
[sensors.acceleration]
kind = "acceleration"
of = "blade.tip"
"#;

fn frequencies(bench: &Workbench, scene: &str) -> Vec<f64> {
    bench.write("pushed.toml", scene);
    bench.run("linearise pushed.toml -o pushed.npz").succeeded();
    let archive = std::fs::read(bench.path("pushed.npz")).unwrap();
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(archive)).unwrap();
    let array = npyz::NpyFile::new(archive.by_name("frequencies_hz.npy").unwrap()).unwrap();
    array.into_vec().unwrap()
}

fn determinant(m: &[[f64; 3]; 3]) -> f64 {
    let minor = |j: usize, k: usize| m[1][j] * m[2][k] - m[1][k] * m[2][j];
    m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1)
}

#[test]
fn loads_at_markers_stiffen_and_soften() {
    let bench = bench();
    let reduce = format!("{REDUCE} --marker tip=TIP --geometric-stiffness --load-stiffness");
    bench
        .run(&format!("{reduce} nose"))
        .failed(1, &["--load-stiffness nose: no such marker", "there are: tip"]);
    bench
        .run(&format!("{REDUCE} --marker tip=TIP --load-stiffness tip"))
        .failed(2, &["--geometric-stiffness"]);
    bench.run(&format!("{reduce} tip")).succeeded();
    let shown = bench.run("inspect blade.ffrf.json").succeeded();
    assert!(shown.contains("of inertial loads, and of loads at tip"), "{shown}");

    let body = body(&bench);
    let number = |value: &Value| value.as_f64().unwrap();
    let load = &body["geometric_stiffness"]["marker_loads"][0];
    assert_eq!(load["marker"], "tip");
    let with = |force: f64| -> [[f64; 3]; 3] {
        std::array::from_fn(|mu| {
            std::array::from_fn(|nu| {
                number(&body["stiffness"][mu][nu]) + force * number(&load["stiffness"][mu][nu][0])
            })
        })
    };
    // Modes of unit mass: the product of the squares of the angular frequencies is the determinant of the stiffness.
    let push = 0.4 * with(0.0)[0][0] / (with(1.0)[0][0] - with(0.0)[0][0]);
    for force in [0.0, -push, 2.0 * push] {
        let found = frequencies(&bench, &PUSHED.replace("PUSH", &format!("{force:e}")));
        assert_eq!(found.len(), 3, "{found:?}");
        let product: f64 = found.iter().map(|f| (std::f64::consts::TAU * f).powi(2)).product();
        let expected = determinant(&with(force));
        assert!((product / expected - 1.0).abs() < 1e-6, "{force}: {product:e}, expected {expected:e}");
    }
    // Fidelities without stiffening do not know the load.
    let level = |fidelity: &str, force: f64| {
        let text = PUSHED.replace("[bodies.blade]", &format!("[bodies.blade]\nfidelity = \"{fidelity}\""));
        frequencies(&bench, &text.replace("PUSH", &format!("{force:e}")))
    };
    for (free, pushed) in level("unstiffened", 0.0).iter().zip(level("unstiffened", -push)) {
        assert!((free / pushed - 1.0).abs() < 1e-6, "{free}, {pushed}");
    }

    // Generated code bends these rows, with other fidelities not.
    assert!(bench.run("generate blade.ffrf.json").succeeded().contains("fn bent_marker"));
    assert!(
        !bench.run("generate blade.ffrf.json --fidelity unstiffened").succeeded().contains("fn bent_marker")
    );
    assert!(bench.run("generate blade.ffrf.json --language c").succeeded().contains("BODY_TIP_STRESSED"));

    // What the marker's place does over time is its velocity, and what that does its acceleration.
    bench.write("pushed.toml", &PUSHED.replace("PUSH", &format!("{:e}", -push)));
    bench.run("simulate pushed.toml -o pushed.csv").succeeded();
    let text = bench.read("pushed.csv");
    let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    let column = |name: &str, row: usize| rows[row][head.iter().position(|it| *it == name).unwrap()];
    for axis in ["x", "y", "z"] {
        for (of, rate) in [("place", "speed"), ("speed", "acceleration")] {
            let (of, rate) = (format!("{of}.{axis}"), format!("{rate}.{axis}"));
            let (mut off, mut largest) = (0.0_f64, 0.0_f64);
            for row in 1..rows.len() - 1 {
                let step = column("t", row + 1) - column("t", row - 1);
                let slope = (column(&of, row + 1) - column(&of, row - 1)) / step;
                off = off.max((slope - column(&rate, row)).abs());
                largest = largest.max(slope.abs());
            }
            // Central differences of 1e-6 s of motions below 20 kHz; along the blade the motion is of second order alone.
            assert!(off < 1e-2 * largest, "{rate}: {off:e} of {largest:e}");
        }
    }
}

#[test]
fn a_cut_shows_the_load_beyond_it() {
    let bench = bench();
    let interfaces = "--interface hold=set:ROOT --interface grip=set:TIP --reference fixed:hold --raw";
    let reduce = "reduce --calculix blade.inp --modes 2 -o blade.ffrf.json";
    bench.run(&format!("{reduce} {interfaces} --section mid=plane:0.25,0.025,0.01,1,0,0")).succeeded();
    assert!(bench.run("inspect blade.ffrf.json").succeeded().contains("section"), "no section shown");
    let scene = r#"
[simulation]
duration = 1e-6
step = 1e-6
[bodies.blade]
model = "blade.ffrf.json"
[joints.clamp]
kind = "fixed"
first = "ground"
first_position = [0.0, 0.025, 0.01]
second = "blade.hold"
[forces.load]
kind = "force"
second = "blade.grip"
value = [300.0, -20.0, 50.0]
[sensors.mid]
kind = "section_force"
of = "blade.mid"
"#;
    bench.write("held.toml", scene);
    bench.run("linearise held.toml --save-state rest.json").succeeded();
    bench.run("simulate held.toml --load-state rest.json -o held.csv").succeeded();
    let text = bench.read("held.csv");
    let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let first: Vec<f64> = text.lines().nth(1).unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    let found = |name: &str| first[head.iter().position(|it| *it == format!("mid.{name}")).unwrap()];
    // The force of the load, and the force times the distance from the cut to the tip.
    let arm = 0.6 - 0.25;
    for (name, expected) in
        [("fx", 300.0), ("fy", -20.0), ("fz", 50.0), ("mx", 0.0), ("my", -50.0 * arm), ("mz", -20.0 * arm)]
    {
        assert!((found(name) - expected).abs() < 0.02, "{name}: {}, expected {expected}", found(name));
    }
    bench.write("held.toml", &scene.replace("blade.mid", "blade.end"));
    bench
        .run("simulate held.toml -o held.csv")
        .failed(1, &["no section is called `blade.end`; there are blade.mid"]);
    let outside = "--section mid=plane:0.7,0,0,1,0,0";
    bench.run(&format!("{reduce} {interfaces} {outside}")).failed(1, &["expected nodes on both sides"]);
    bench.run(&format!("{reduce} --section mid=plane:1")).failed(2, &["found 1 numbers"]);
}
