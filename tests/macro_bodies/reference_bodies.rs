//! Every public reference case through compiled macro code, the way a user gets there:
//! finite-element files -> reduced body -> `flexible_body!` in a crate of its own -> numbers.
#![allow(clippy::expect_used)] // helpers of tests are tests

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use ffrf_fe::import::{self, ModelFiles, NodeSource};
use ffrf_fe::modes;
use ffrf_fe::reduction::{self, MarkerRequest, ReductionOptions};

/// Cases with a nodal table, mass, stiffness and mode shapes, and their mode counts.
const CASES: [(&str, usize); 8] = [
    ("synth_m1", 1),
    ("synth_m2", 2),
    ("synth_m3", 3),
    ("synth_m5", 5),
    ("truss3", 2),
    ("blockC3D8", 4),
    ("blockC3D10", 4),
    ("rotorDisc", 8),
];

#[test]
fn compiled_bodies_agree_with_the_reference_cases() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let reference = root.join("../shared/reference");
    if !reference.is_dir() {
        eprintln!("SKIPPED: no reference cases at {}", reference.display());
        return;
    }
    let scratch = scratch_crate(root, &reference);
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--offline", "--manifest-path"])
        .arg(scratch.join("Cargo.toml"))
        .arg("--")
        .arg(reference.canonicalize().expect("reference folder"))
        // What the workspace has built is used; `scratch` is in the `tmp` of its target folder.
        .env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("a target folder"))
        .output()
        .expect("cargo runs");
    let (told, complaints) =
        (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    println!("{told}");
    assert!(output.status.success(), "{told}\n{complaints}");
    assert!(told.contains("0 comparisons failed"), "{told}");
}

/// Copies tests/reference-bodies and fills in the models and the bodies.
fn scratch_crate(root: &Path, reference: &Path) -> PathBuf {
    let scratch = Path::new(env!("CARGO_TARGET_TMPDIR")).join("reference-bodies");
    let template = root.join("tests/reference-bodies");
    fs::create_dir_all(scratch.join("src")).expect("scratch folder");
    fs::create_dir_all(scratch.join("models")).expect("scratch folder");
    let manifest = fs::read_to_string(template.join("Cargo.toml")).expect("template manifest");
    write_if_changed(&scratch.join("Cargo.toml"), &manifest.replace("@FFRF@", &root.display().to_string()));
    // The lock file of the workspace keeps the scratch crate on the same versions, without asking the registry.
    write_if_changed(
        &scratch.join("Cargo.lock"),
        &fs::read_to_string(root.join("Cargo.lock")).expect("lock file"),
    );
    for entry in fs::read_dir(template.join("src")).expect("template sources") {
        let path = entry.expect("template source").path();
        let text = fs::read_to_string(&path).expect("template source");
        write_if_changed(&scratch.join("src").join(path.file_name().expect("file name")), &text);
    }
    let mut bodies =
        String::from("//! The reference bodies, baked in.\n\nuse crate::{Run, states, trajectory};\n\n");
    let mut calls = String::new();
    for (name, modes) in CASES {
        let body = reduce(reference, name);
        assert_eq!(body.mode_count(), modes, "{name}");
        write_if_changed(
            &scratch.join(format!("models/{name}.ffrf.json")),
            &body.to_json().expect("a valid body"),
        );
        let type_name = name.replace(['_'], "").to_uppercase();
        bodies.push_str(&format!(
            "ffrf::flexible_body! {{ pub struct {type_name} {{ model: \"models/{name}.ffrf.json\", modes: ..{modes}, scalar: f64 }} }}\n"
        ));
        calls.push_str(&format!(
            "    states::check::<{type_name}, {modes}, {}>(run, \"{name}\", &{type_name});\n",
            6 + modes
        ));
    }
    calls.push_str("    trajectory::check(run, \"traj_free_synth_m3\", SYNTHM3);\n");
    bodies.push_str(&format!("\npub fn check_all(run: &mut Run) {{\n{calls}}}\n"));
    write_if_changed(&scratch.join("src/bodies.rs"), &bodies);
    scratch
}

/// Keeps the time stamp, and so the build, of a file that has not changed.
fn write_if_changed(path: &Path, text: &str) {
    if fs::read_to_string(path).is_ok_and(|old| old == text) {
        return;
    }
    fs::write(path, text).expect("scratch file");
}

/// The case's finite-element data, reduced with its own mode shapes and a marker at every node.
fn reduce(reference: &Path, name: &str) -> ffrf_model::ReducedBody {
    let folder = reference.join("fe").join(name);
    let model = import::read_model(&ModelFiles {
        nodes: NodeSource::Text(folder.join("X.txt")),
        mass: Some(folder.join("Ms.mtx")),
        stiffness: Some(folder.join("K.mtx")),
    })
    .expect("the reference data imports");
    let shapes =
        import::read_mode_shapes(&folder.join("Psi.txt"), model.nodes.len()).expect("mode shapes import");
    let solution = modes::user_modes(&model, shapes).expect("mode shapes are accepted");
    let markers = (0..model.nodes.len())
        .map(|node| MarkerRequest { name: format!("NODE_{node}"), nodes: vec![node] })
        .collect();
    let options = ReductionOptions { title: name.to_owned(), markers, ..Default::default() };
    reduction::reduce(&model, &solution.basis, &options).expect("the reduction succeeds")
}
