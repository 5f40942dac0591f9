//! Generates the bodies that the harness has made in the folder `FFRF_BODIES`, and straight-line code of whole mechanisms.

mod straight_line;

use std::path::Path;

use ffrf_codegen::{GenerateOptions, generate};
use ffrf_model::ReducedBody;

/// Modes that a program computed are orthonormal up to the rounding of their numbers.
const LAYOUT_TOLERANCE: f64 = 1e-12;

fn main() {
    println!("cargo::rerun-if-env-changed=FFRF_BODIES");
    println!("cargo::rerun-if-changed=build");
    let out = std::env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    let write = |name: &str, code: String| {
        std::fs::write(Path::new(&out).join(name), code).expect("OUT_DIR can be written to");
    };
    write("pendulums.rs", straight_line::pendulums());
    // the chains need no body of the harness
    let Ok(folder) = std::env::var("FFRF_BODIES") else { return };
    let mut cases = vec![("Rod", "rod", "slider_crank")];
    if std::env::var("CARGO_FEATURE_ROTOR").is_ok() {
        cases.push(("Rotor", "rotor", "rotor"));
    }
    for (name, file, scene) in cases {
        let path = Path::new(&folder).join(format!("{file}.ffrf.json"));
        println!("cargo::rerun-if-changed={}", path.display());
        let body = ReducedBody::read(&path).expect("the harness has made this body");
        let options = GenerateOptions {
            name: name.to_owned(),
            layout_tolerance: LAYOUT_TOLERANCE,
            ..GenerateOptions::default()
        };
        write(&format!("{file}.rs"), generate(&body, &options).expect("a checked body").text);
        write(&format!("{scene}_straight_line.rs"), straight_line::scene(scene, Path::new(&folder)));
    }
}
