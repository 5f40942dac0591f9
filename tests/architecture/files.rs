//! How files must look.

use std::fs;

use crate::workspace::{root, source_files};

#[test]
fn files_are_small_and_say_what_they_are() {
    let mut offences = Vec::new();
    for path in source_files() {
        let text = fs::read_to_string(&path).expect("readable file");
        let lines = text.lines().count();
        let shown = path.strip_prefix(root()).unwrap_or(&path).display();
        if lines > 500 {
            offences.push(format!("{shown}: {lines} lines, at most 500"));
        }
        if !text.starts_with("//!") {
            offences.push(format!("{shown}: must start with a `//!` line"));
        }
    }
    assert!(offences.is_empty(), "{}", offences.join("\n"));
}
