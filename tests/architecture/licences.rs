//! What is published comes with its licences: a package holds the files of its own folder alone.

use std::fs;

use crate::workspace::{metadata, root};

#[test]
fn every_published_package_has_the_licence_texts() {
    let mut offences = Vec::new();
    let mut published = 0;
    for package in metadata().workspace_packages() {
        if package.publish.as_ref().is_some_and(Vec::is_empty) {
            continue;
        }
        published += 1;
        let folder = package.manifest_path.parent().expect("a manifest is in a folder");
        for name in ["LICENSE-MIT", "LICENSE-APACHE"] {
            let whole = fs::read(root().join(name)).expect("the licences stand at the root");
            if fs::read(folder.join(name)).ok().as_ref() != Some(&whole) {
                offences.push(format!("{folder}/{name} is not the file of that name at the root"));
            }
        }
        if package.license.is_none() || package.description.is_none() || package.repository.is_none() {
            offences.push(format!("{} names no licence, description or repository", package.name));
        }
    }
    assert!(published > 5, "the walk found only {published} packages");
    assert!(offences.is_empty(), "{}", offences.join("\n"));
}
