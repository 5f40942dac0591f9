//! Gives the linker the memory of the boards.

use std::path::PathBuf;

/// Memory of the emulated boards mps2-an386 and mps2-an500, as much of it as is used.
const MEMORY: &str =
    "MEMORY {\n  FLASH : ORIGIN = 0x00000000, LENGTH = 4M\n  RAM : ORIGIN = 0x20000000, LENGTH = 1M\n}\n";

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if let Some(folder) = std::env::var_os("OUT_DIR").map(PathBuf::from) {
        if let Err(error) = std::fs::write(folder.join("memory.x"), MEMORY) {
            println!("cargo:error=memory.x cannot be written: {error}");
        }
        println!("cargo:rustc-link-search={}", folder.display());
    }
}
