//! Links the C runtime's start code, which calls `main`; nothing else of it is used. Generates a body of many modes.

#[path = "../../ffrf-codegen/tests/common/random_body.rs"]
#[allow(dead_code)]
mod random_body;

use ffrf_codegen::{GenerateOptions, generate};
use random_body::{Modes, random_body};

/// The first number of modes whose moments are stored by half.
const MANY: usize = 20;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-link-lib=c");
    let body = random_body(9, MANY, Modes::Normalised);
    // Orthogonal up to the rounding of a few hundred products.
    let options = GenerateOptions {
        name: "ManyModes".to_owned(),
        layout_tolerance: 1e-12,
        ..GenerateOptions::default()
    };
    let code = generate(&body, &options).expect("a random body can be generated");
    let strategy = code.report.lanes.expect("20 modes are computed in lanes");
    assert!(strategy.contains("by half"), "{strategy}");
    let path = std::path::Path::new(&std::env::var("OUT_DIR").expect("cargo sets it")).join("many_modes.rs");
    std::fs::write(path, code.text).expect("OUT_DIR can be written to");
}
