//! Who may import whom.

use std::collections::BTreeMap;

use cargo_metadata::DependencyKind;

use crate::workspace::metadata;

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
                &[
                    "anyhow",
                    "clap",
                    "faer",
                    "indicatif",
                    "plotters",
                    "prettyplease",
                    "serde",
                    "serde_json",
                    "tempfile",
                ],
            ),
        ),
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
