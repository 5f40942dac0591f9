//! Who may import whom.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use cargo_metadata::DependencyKind;

use crate::workspace::{metadata, package_of, packages, root, source_files};

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
                &["faer", "fast-float2", "flate2", "npyz", "quick-xml", "sha2", "thiserror", "zip"],
            ),
        ),
        ("ffrf-codegen", entry(&["ffrf-model"], &["proc-macro2", "thiserror"])),
        ("ffrf-macros", entry(&["ffrf-codegen", "ffrf-model"], &["proc-macro2", "quote", "syn"])),
        ("ffrf-runtime", entry(&[], &["fearless_simd", "nalgebra", "wide"])),
        (
            "ffrf-cli",
            entry(
                &["ffrf-codegen", "ffrf-fe", "ffrf-fmu", "ffrf-host", "ffrf-model"],
                &[
                    "anyhow",
                    "base64",
                    "clap",
                    "indicatif",
                    "npyz",
                    "plotters",
                    "png",
                    "serde",
                    "serde_json",
                    "zip",
                ],
            ),
        ),
        (
            "ffrf-host",
            entry(
                &["ffrf-codegen", "ffrf-model", "ffrf-runtime", "ffrf-trace"],
                &["faer", "nalgebra", "num-dual", "serde", "thiserror", "toml"],
            ),
        ),
        ("ffrf-trace", entry(&["ffrf-codegen"], &["approx", "nalgebra", "num-traits", "simba"])),
        ("ffrf-c-interface", entry(&["ffrf"], &[])),
        ("ffrf-fmu", entry(&["ffrf-codegen", "ffrf-host"], &["sha2", "thiserror"])),
        ("ffrf-python", entry(&["ffrf-cli", "ffrf-host", "ffrf-model"], &["anyhow", "pyo3", "serde_json"])),
        (
            "ffrf-test-kit",
            entry(
                &["ffrf-codegen", "ffrf-model", "ffrf-runtime"],
                &["num-rational", "num-traits", "serde_json"],
            ),
        ),
    ])
}

#[test]
fn every_crate_keeps_the_import_law() {
    let law = law();
    let mut offences = Vec::new();
    let mut seen = 0;
    for package in packages() {
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
fn every_permitted_crate_is_used() {
    let law = law();
    let mut offences = Vec::new();
    for package in packages() {
        let Some(allowed) = law.get(package.name.as_str()) else { continue };
        for permitted in allowed.ours.iter().chain(allowed.others) {
            let mut normal = package.dependencies.iter().filter(|d| d.kind == DependencyKind::Normal);
            if !normal.any(|dependency| dependency.name.as_str() == *permitted) {
                offences.push(format!("{} may depend on {permitted}, and does not", package.name));
            }
        }
    }
    assert!(offences.is_empty(), "the import law permits too much:\n{}", offences.join("\n"));
}

#[test]
fn every_dependency_is_named_by_a_source() {
    let mut offences = Vec::new();
    for package in packages() {
        let folder = package.manifest_path.parent().expect("a manifest is in a folder");
        let sources: Vec<String> = source_files()
            .into_iter()
            .filter(|path| package_of(path) == folder.as_std_path())
            .map(|path| fs::read_to_string(path).expect("readable file"))
            .collect();
        for dependency in &package.dependencies {
            let path = format!("{}::", dependency.name.replace('-', "_"));
            if !sources.iter().any(|text| text.contains(&path)) {
                offences.push(format!(
                    "{} depends on {}, which no source of it names",
                    package.name, dependency.name
                ));
            }
        }
    }
    assert!(offences.is_empty(), "unused dependencies:\n{}", offences.join("\n"));
}

/// Dependencies of the workspace table that no package asks for.
#[test]
fn every_shared_dependency_is_used() {
    let text = fs::read_to_string(root().join("Cargo.toml")).expect("readable manifest");
    let table = text.split_once("[workspace.dependencies]").map_or("", |(_, rest)| rest);
    let table = table.split("\n[").next().unwrap_or(table);
    let used: BTreeSet<String> = metadata()
        .workspace_packages()
        .iter()
        .flat_map(|package| package.dependencies.iter().map(|d| d.name.clone()))
        .collect();
    let names = table.lines().filter_map(|line| line.split_once(" =")).map(|(name, _)| name);
    let unused: Vec<&str> =
        names.filter(|name| !name.starts_with('#') && !used.contains(*name) && *name != "ffrf").collect();
    assert!(unused.is_empty(), "nobody uses {}", unused.join(", "));
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
