//! No source file is included by its path into another package: what packages share is a package.

use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::workspace::{root, source_files};

/// The folder of the package that a file belongs to.
fn package_of(file: &Path) -> Option<&Path> {
    file.ancestors().skip(1).find(|folder| folder.join("Cargo.toml").is_file())
}

/// The path without `..`, as text alone.
fn normalised(path: &Path) -> PathBuf {
    let mut result = PathBuf::new();
    for component in path.components() {
        match component {
            Component::ParentDir => {
                result.pop();
            }
            other => result.push(other),
        }
    }
    result
}

/// What the lines with `#[path = "..."]` name, relative to the folder of their file.
fn named_paths(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| {
        let rest = line.trim_start().strip_prefix("#[path")?.trim_start().strip_prefix('=')?;
        rest.split('"').nth(1)
    })
}

#[test]
fn no_path_leads_into_another_package() {
    let mut offences = Vec::new();
    let mut seen = 0;
    for file in source_files() {
        let text = fs::read_to_string(&file).expect("readable file");
        for named in named_paths(&text) {
            seen += 1;
            let target = normalised(&file.parent().unwrap_or(root()).join(named));
            let shown = file.strip_prefix(root()).unwrap_or(&file).display();
            if !target.is_file() {
                offences.push(format!("{shown}: {named} is not there"));
            } else if package_of(&target) != package_of(&file) {
                offences
                    .push(format!("{shown}: {named} belongs to another package; share it through tests/kit"));
            }
        }
    }
    assert!(seen > 5, "the walk found only {seen} paths");
    assert!(offences.is_empty(), "{}", offences.join("\n"));
}

#[test]
fn a_path_into_another_package_would_be_found() {
    let text =
        "    #[path = \"../../ffrf-runtime/src/lib.rs\"]\nmod runtime;\n#[path=\"here.rs\"]\nmod here;\n";
    assert_eq!(named_paths(text).collect::<Vec<_>>(), ["../../ffrf-runtime/src/lib.rs", "here.rs"]);
    let file = root().join("tests/architecture/paths.rs");
    let target = normalised(&root().join("tests/architecture/../../ffrf-runtime/src/lib.rs"));
    assert_eq!(package_of(&target), Some(root().join("ffrf-runtime").as_path()));
    assert_eq!(package_of(&file), Some(root()));
}
