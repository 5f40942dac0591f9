//! `ffrf reduce` of meshes, whose mass and stiffness it assembles, and of Nastran's decks and punch files.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::fmt::Write as _;
use std::path::Path;

use ffrf_fe::elements::{Material, brick};
use serde_json::Value;

use crate::workbench::Workbench;

/// The beam of `ffrf-fe/tests/data/gmsh`: 1 m x 0.1 m x 0.2 m of steel.
const REDUCE: &str = "reduce beam.msh --material 7850,2.1e11,0.3 -o beam.ffrf.json";
const VERIFY: &str = "verify beam.ffrf.json beam.msh --material 7850,2.1e11,0.3";

/// A mass is a sum over nodes.
const ROUND_OFF: f64 = 1e-9;

fn data(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../ffrf-fe/tests/data").join(file);
    std::fs::read_to_string(path).unwrap()
}

fn bench(mesh: &str) -> Workbench {
    let bench = Workbench::new();
    bench.write("beam.msh", &data(&format!("gmsh/{mesh}")));
    bench
}

fn body(bench: &Workbench, file: &str) -> Value {
    serde_json::from_str(&bench.read(file)).unwrap()
}

#[test]
fn a_mesh_of_gmsh_is_assembled_reduced_and_verified() {
    for mesh in ["hex20_4.1.msh", "hex20_2.2.msh", "tet10_4.1.msh"] {
        let bench = bench(mesh);
        let run = bench.run(&format!("{REDUCE} --modes 4 --stress edge=edge --geometric-stiffness"));
        assert!(
            run.stderr.contains("note: beam.msh: mass (consistent) and stiffness are assembled"),
            "{}",
            run.stderr
        );
        run.succeeded();
        let body = body(&bench, "beam.ffrf.json");
        let mass = body["inertia"]["mass"].as_f64().unwrap();
        assert!((mass / (7850.0 * 0.02) - 1.0).abs() < ROUND_OFF, "{mass}");
        assert_eq!(body["provenance"]["sources"][0]["role"], "mesh");
        let said = bench.run(&format!("{VERIFY} --modes 4")).succeeded();
        assert!(said.contains("verified"), "{said}");
    }
}

#[test]
fn physical_groups_hold_interfaces_and_supports() {
    let bench = bench("hex20_4.1.msh");
    bench.run_words(REDUCE.split(' ').chain(["--modes", "2", "--clamp", "left end"])).succeeded();
    let interfaces = ["--modes", "2", "--interface", "ROOT=set:left end,rbe2", "--basis", "craig-bampton"];
    bench.run_words(REDUCE.split(' ').chain(interfaces)).succeeded();
    bench
        .run_words(REDUCE.split(' ').chain(["--modes", "2", "--clamp", "right end"]))
        .failed(1, &["`right end` is neither a node set", "edge, left end, part, point_8"]);
}

#[test]
fn meshes_that_cannot_be_assembled_are_refused() {
    let bench = bench("hex8_4.1.msh");
    bench
        .run("reduce beam.msh --modes 2 -o b.ffrf.json")
        .failed(1, &["the mass file is missing", "--material"]);
    bench
        .run("reduce beam.msh --material 7850,2.1e11,0.5 --modes 2 -o b.ffrf.json")
        .failed(1, &["the material must have", "0.5"]);
    bench
        .run("reduce beam.msh --material 7850,2.1e11 --modes 2 -o b.ffrf.json")
        .failed(2, &["expected three numbers, RHO,E,NU, found 2"]);
    let text = bench.read("beam.msh");
    bench.write("beam.msh", &text.replace("$EndElements", "$EndElement"));
    bench
        .run(&format!("{REDUCE} --modes 2"))
        .failed(1, &["beam.msh:", "expected `$EndElements`", "`$EndElement`"]);
    assert_eq!(bench.files(), ["beam.msh"]);
}

/// A bar of six hexahedra along x, two in the group `HUB`, the others in `ARM`.
fn two_groups() -> String {
    let bar = brick([0.6, 0.1, 0.1], [6, 1, 1], &Material::STEEL).unwrap();
    let mut text = String::from("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
    text.push_str("$PhysicalNames\n2\n3 1 \"HUB\"\n3 2 \"ARM\"\n$EndPhysicalNames\n");
    writeln!(text, "$Nodes\n{}", bar.nodes.len()).unwrap();
    for (row, [x, y, z]) in bar.nodes.positions.iter().enumerate() {
        writeln!(text, "{} {x} {y} {z}", row + 1).unwrap();
    }
    writeln!(text, "$EndNodes\n$Elements\n{}", bar.elements.len()).unwrap();
    for (number, element) in bar.elements.iter().enumerate() {
        let nodes: Vec<String> = element.nodes.iter().map(|row| (row + 1).to_string()).collect();
        let group = if number < 2 { 1 } else { 2 };
        writeln!(text, "{} 5 2 {group} {group} {}", number + 1, nodes.join(" ")).unwrap();
    }
    text + "$EndElements\n"
}

#[test]
fn each_group_of_solids_has_its_own_material() {
    let bench = Workbench::new();
    bench.write("bar.msh", &two_groups());
    let of = |materials: &str| format!("bar.msh {materials} --clamp 1,8,15,22 --modes 3");
    let materials = "--material HUB=7850,2.1e11,0.3 --material ARM=1600,7e10,0.25";
    let stiffened = "--stress seam=3 --geometric-stiffness -o bar.ffrf.json";
    bench.run(&format!("reduce {} {stiffened}", of(materials))).succeeded();
    let found = body(&bench, "bar.ffrf.json");
    let mass = found["inertia"]["mass"].as_f64().unwrap();
    assert!((mass / (7850.0 * 2e-3 + 1600.0 * 4e-3) - 1.0).abs() < ROUND_OFF, "{mass}");
    let first_moment = found["inertia"]["first_moment"][0].as_f64().unwrap();
    let expected = 7850.0 * 2e-3 * 0.1 + 1600.0 * 4e-3 * 0.4;
    assert!((first_moment / expected - 1.0).abs() < ROUND_OFF, "{first_moment} {expected}");
    let notes = found["provenance"]["notes"].to_string();
    for part in ["2 of group HUB with density 7850.0", "4 of group ARM with density 1600.0"] {
        assert!(notes.contains(part), "{notes}");
    }
    let said = bench.run(&format!("verify bar.ffrf.json {} --tolerance 1e-6", of(materials))).succeeded();
    assert!(said.contains("verified"), "{said}");
    // Another material of one group is another part.
    let other = of("--material HUB=7850,2.1e11,0.3 --material 1600,7.7e10,0.25");
    assert_ne!(bench.run(&format!("verify bar.ffrf.json {other} --tolerance 1e-6")).code, 0);
    let refused = |materials: &str, parts: &[&str]| {
        bench.run(&format!("reduce {} -o b.ffrf.json", of(materials))).failed(1, parts);
    };
    refused(
        "--material HUB=7850,2.1e11,0.3",
        &["the first of 4", "groups of solids: ARM (4 solids), HUB (2 solids)"],
    );
    refused("--material TIP=7850,2.1e11,0.3", &["no solid is in a group TIP", "ARM (4 solids)"]);
}

#[test]
fn deck_and_punch_file_of_nastran_are_reduced_and_verified() {
    let bench = Workbench::new();
    for file in ["part.bdf", "part.pch"] {
        bench.write(file, &data(&format!("nastran/{file}")));
    }
    let files = "--nastran part.bdf --mass part.pch --stiffness part.pch --modes 3";
    let run =
        bench.run(&format!("reduce {files} --marker end=SET4 --stress end_stress=SET4 -o part.ffrf.json"));
    assert!(run.stderr.contains("1 node is in no matrix and left out (node 99)"), "{}", run.stderr);
    run.succeeded();
    let mass = body(&bench, "part.ffrf.json")["inertia"]["mass"].as_f64().unwrap();
    assert!((mass / (7850.0 * 0.5 * 0.25 * 0.125) - 1.0).abs() < ROUND_OFF, "{mass}");
    let said = bench.run(&format!("verify part.ffrf.json {files}")).succeeded();
    assert!(said.contains("verified"), "{said}");
}
