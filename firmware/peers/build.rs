//! Links the start code and the C that run.sh compiled, CasADi's or ours, and writes the body for this run.

use std::path::PathBuf;

fn main() {
    for name in ["PEERS_MODES", "PEERS_SCALAR", "PEERS_LIBRARY"] {
        println!("cargo:rerun-if-env-changed={name}");
    }
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    let value = |name: &str| std::env::var(name).unwrap_or_else(|_| panic!("{name} is not set: use run.sh"));
    let (modes, scalar, library) =
        (value("PEERS_MODES"), value("PEERS_SCALAR"), PathBuf::from(value("PEERS_LIBRARY")));
    println!("cargo:rerun-if-changed={}", library.display());
    for name in ["c_accelerations", "c_equations"] {
        println!("cargo:rustc-link-arg-bin={name}={}", library.display());
    }
    let text = format!(
        "pub type Scalar = {scalar};\npub const MODES: usize = {modes};\npub const ALL: usize = 6 + MODES;\n\
         ffrf::flexible_body! {{\n    pub struct Body {{ model: \"../../models/conrod.ffrf.json\", modes: ..{modes}, scalar: {scalar}, fma: off, layout_tolerance: 1e-9 }}\n}}\n"
    );
    let folder = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets it"));
    std::fs::write(folder.join("body.rs"), text).expect("OUT_DIR can be written to");
}
