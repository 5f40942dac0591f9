//! Links the C runtime's start code, which calls `main`; nothing else of it is used.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-link-lib=c");
}
