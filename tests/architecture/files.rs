//! How files must look.

use std::fs;

use crate::workspace::{metadata, root, source_files};

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

/// Each program of tests is compiled, linked and run by itself: a new test is a module of one that is there.
#[test]
fn integration_tests_are_few_programs() {
    let mut offences = Vec::new();
    let mut seen = 0;
    for package in metadata().workspace_packages() {
        let programs: Vec<&str> =
            package.targets.iter().filter(|target| target.is_test()).map(|target| &*target.name).collect();
        seen += programs.len();
        let most = if package.name.as_str() == "ffrf" { 8 } else { 4 };
        if programs.len() > most {
            offences.push(format!("{}: at most {most}, found {}", package.name, programs.join(", ")));
        }
    }
    assert!(seen > 10, "the walk found only {seen} programs");
    assert!(offences.is_empty(), "programs of tests:\n{}", offences.join("\n"));
}
