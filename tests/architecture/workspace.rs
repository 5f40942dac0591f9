//! The packages and the source files of the workspace.

use std::fs;
use std::path::{Path, PathBuf};

use cargo_metadata::{Metadata, MetadataCommand, Package};

/// The packages of the workspace, without their dependencies.
pub fn metadata() -> Metadata {
    metadata_of("Cargo.toml")
}

/// The packages of the workspace, and that of Python, which is a workspace of its own but keeps the same law.
pub fn packages() -> Vec<Package> {
    let both = [metadata(), metadata_of("ffrf-python/Cargo.toml")];
    both.iter().flat_map(|metadata| metadata.workspace_packages().into_iter().cloned()).collect()
}

fn metadata_of(manifest: &str) -> Metadata {
    let mut command = MetadataCommand::new();
    command.manifest_path(root().join(manifest)).no_deps().exec().expect("cargo metadata runs")
}

/// The folder of the workspace.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The folder of the package that a file is in.
pub fn package_of(path: &Path) -> &Path {
    path.ancestors().skip(1).find(|folder| folder.join("Cargo.toml").exists()).unwrap_or(root())
}

/// Hand-written Rust files: all but generated golden code and compile-fail samples.
pub fn source_files() -> Vec<PathBuf> {
    files_ending_in("rs")
}

/// Documents.
pub fn text_files() -> Vec<PathBuf> {
    files_ending_in("md")
}

fn files_ending_in(extension: &str) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![root().to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("readable folder") {
            let path = entry.expect("readable entry").path();
            let name = path.file_name().and_then(|n| n.to_str()).unwrap_or_default();
            if path.is_dir() {
                if !matches!(name, "target" | "golden" | "ui" | "snapshots") && !name.starts_with('.') {
                    folders.push(path);
                }
            } else if path.extension().is_some_and(|e| e == extension) {
                files.push(path);
            }
        }
    }
    files.sort();
    assert!(files.len() > 5, "the walk found only {} files", files.len());
    files
}
