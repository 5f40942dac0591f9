//! Generates the bodies that the harness has made in the folder `FFRF_BODIES`.

use std::path::Path;

use ffrf_codegen::{GenerateOptions, generate};
use ffrf_model::ReducedBody;

/// Modes that a program computed are orthonormal up to the rounding of their numbers.
const LAYOUT_TOLERANCE: f64 = 1e-12;

fn main() {
    println!("cargo::rerun-if-env-changed=FFRF_BODIES");
    // the chains need no body of the harness
    let Ok(folder) = std::env::var("FFRF_BODIES") else { return };
    let out = std::env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    let mut bodies = vec![("Rod", "rod")];
    if std::env::var("CARGO_FEATURE_ROTOR").is_ok() {
        bodies.push(("Rotor", "rotor"));
    }
    for (name, file) in bodies {
        let path = Path::new(&folder).join(format!("{file}.ffrf.json"));
        println!("cargo::rerun-if-changed={}", path.display());
        let body = ReducedBody::read(&path).expect("the harness has made this body");
        let options = GenerateOptions {
            name: name.to_owned(),
            layout_tolerance: LAYOUT_TOLERANCE,
            ..GenerateOptions::default()
        };
        let code = generate(&body, &options).expect("a checked body").text;
        std::fs::write(Path::new(&out).join(format!("{file}.rs")), code).expect("OUT_DIR can be written to");
    }
}
