//! The structure of the workspace as a test: who may import whom, and how files must look.
//!
//! ARCHITECTURE.md states the same law for people; a change there is a change here.
#![allow(clippy::expect_used)] // helpers of tests are tests

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use cargo_metadata::{DependencyKind, Metadata, MetadataCommand};

/// What a crate may use in its normal (not development) dependencies.
struct Allowed {
    ours: &'static [&'static str],
    others: &'static [&'static str],
}

fn law() -> BTreeMap<&'static str, Allowed> {
    let entry = |ours, others| Allowed { ours, others };
    BTreeMap::from([
        ("ffrf", entry(&["ffrf-macros", "ffrf-runtime"], &[])),
        ("ffrf-model", entry(&[], &["serde", "serde_json", "serde_path_to_error", "thiserror"])),
        (
            "ffrf-fe",
            entry(
                &["ffrf-model"],
                &["faer", "fast-float2", "flate2", "npyz", "sha2", "tempfile", "thiserror", "zip"],
            ),
        ),
        (
            "ffrf-codegen",
            entry(
                &["ffrf-model"],
                &["proc-macro2", "quote", "thiserror", "num-bigint", "num-rational", "num-traits"],
            ),
        ),
        ("ffrf-macros", entry(&["ffrf-codegen", "ffrf-model"], &["proc-macro2", "quote", "syn"])),
        ("ffrf-runtime", entry(&[], &["nalgebra", "wide"])),
        (
            "ffrf-cli",
            entry(
                &["ffrf-codegen", "ffrf-fe", "ffrf-model", "ffrf-runtime"],
                &["anyhow", "clap", "faer", "indicatif", "prettyplease", "serde", "serde_json", "tempfile"],
            ),
        ),
    ])
}

fn metadata() -> Metadata {
    MetadataCommand::new()
        .manifest_path(root().join("Cargo.toml"))
        .no_deps()
        .exec()
        .expect("cargo metadata runs")
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn every_crate_keeps_the_import_law() {
    let law = law();
    let metadata = metadata();
    let mut offences = Vec::new();
    let mut seen = 0;
    for package in metadata.workspace_packages() {
        let name = package.name.as_str();
        let Some(allowed) = law.get(name) else {
            offences.push(format!("{name} has no entry in the import law"));
            continue;
        };
        seen += 1;
        for dependency in package.dependencies.iter().filter(|d| d.kind == DependencyKind::Normal) {
            let used = dependency.name.as_str();
            let permitted = if used.starts_with("ffrf") { allowed.ours } else { allowed.others };
            if !permitted.contains(&used) {
                offences.push(format!("{name} must not depend on {used}"));
            }
        }
    }
    assert_eq!(seen, law.len(), "every crate of the law exists");
    assert!(offences.is_empty(), "import law broken:\n{}", offences.join("\n"));
}

#[test]
fn the_runtime_takes_no_default_features() {
    let metadata = metadata();
    let runtime =
        metadata.packages.iter().find(|p| p.name.as_str() == "ffrf-runtime").expect("ffrf-runtime exists");
    for dependency in runtime.dependencies.iter().filter(|d| d.kind == DependencyKind::Normal) {
        assert!(
            !dependency.uses_default_features,
            "ffrf-runtime must switch off the default features of {}",
            dependency.name
        );
    }
}

/// Hand-written Rust files: all but generated golden code and compile-fail samples.
fn source_files() -> Vec<PathBuf> {
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
            } else if path.extension().is_some_and(|e| e == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    assert!(files.len() > 20, "the walk found only {} files", files.len());
    files
}

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

#[test]
fn every_crate_root_forbids_unsafe_code() {
    for package in metadata().workspace_packages() {
        for target in package.targets.iter().filter(|t| t.is_lib() || t.is_bin() || t.is_proc_macro()) {
            let text = fs::read_to_string(&target.src_path).expect("readable crate root");
            assert!(text.contains("#![forbid(unsafe_code)]"), "{} must forbid unsafe code", target.src_path);
        }
    }
}

#[test]
fn the_generator_touches_neither_files_nor_environment() {
    for path in source_files().iter().filter(|p| p.starts_with(root().join("ffrf-codegen/src"))) {
        let text = fs::read_to_string(path).expect("readable file");
        for forbidden in ["std::fs", "std::env", "std::time"] {
            assert!(!text.contains(forbidden), "{} must not use {forbidden}", path.display());
        }
    }
}
