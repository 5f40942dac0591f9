//! Links the C runtime's start code, which calls `main`; nothing else of it is used. Generates a body of many modes.

use ffrf_codegen::{GenerateOptions, generate};
use ffrf_test_kit::random_body::{Modes, random_body};

/// The first number of modes whose moments are stored by half.
const MANY: usize = 20;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-link-lib=c");
    write("ManyModes", MANY, Modes::Normalised, "by half");
    write("DenseModalMass", 9, Modes::Random, "whole table");
}

/// Writes a body whose moments are stored in this way into a file of its name.
fn write(name: &str, modes: usize, kind: Modes, storage: &str) {
    let body = random_body(9, modes, kind);
    // Orthogonal up to the rounding of a few hundred products.
    let options =
        GenerateOptions { name: name.to_owned(), layout_tolerance: 1e-12, ..GenerateOptions::default() };
    let code = generate(&body, &options).expect("a random body can be generated");
    let strategy = code.report.lanes.expect("so many modes are computed in lanes");
    assert!(strategy.contains(storage), "{strategy}");
    let folder = std::env::var("OUT_DIR").expect("cargo sets it");
    let path = std::path::Path::new(&folder).join(format!("{name}.rs"));
    std::fs::write(path, code.text).expect("OUT_DIR can be written to");
}
