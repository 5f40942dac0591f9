//! What the generator must not touch.

use std::fs;

use crate::workspace::{root, source_files};

#[test]
fn the_generator_touches_neither_files_nor_environment() {
    for path in source_files().iter().filter(|p| p.starts_with(root().join("ffrf-codegen/src"))) {
        let text = fs::read_to_string(path).expect("readable file");
        for forbidden in ["std::fs", "std::env", "std::time"] {
            assert!(!text.contains(forbidden), "{} must not use {forbidden}", path.display());
        }
    }
}
