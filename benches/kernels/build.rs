//! Writes one module per case, and a file that lists them.

#[path = "src/cases.rs"]
mod cases;

use std::fmt::Write as _;
use std::path::Path;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=src/cases.rs");
    let folder = std::env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    let mut list = String::new();
    for case in cases::all() {
        let code = ffrf_codegen::generate(&case.body, &case.options).expect("every case can be generated");
        std::fs::write(Path::new(&folder).join(format!("{}.rs", case.name)), code.text)
            .expect("OUT_DIR can be written to");
        let _ =
            writeln!(list, "pub mod {0} {{ include!(concat!(env!(\"OUT_DIR\"), \"/{0}.rs\")); }}", case.name);
    }
    std::fs::write(Path::new(&folder).join("bodies.rs"), list).expect("OUT_DIR can be written to");
}
