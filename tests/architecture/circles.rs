//! Sibling files and folders of a crate import each other in one direction only.

use std::collections::{BTreeMap, BTreeSet};

use crate::modules::{Crate, Module};
use crate::workspace::packages;

/// Between the children of one module: who imports whom, with one import that shows it.
type Imports = BTreeMap<String, BTreeMap<String, String>>;

#[test]
fn siblings_import_each_other_in_one_direction() {
    let mut circles = BTreeMap::new();
    for package in packages() {
        for target in
            package.targets.iter().filter(|t| t.is_lib() || t.is_cdylib() || t.is_bin() || t.is_proc_macro())
        {
            let code = Crate::read(target.src_path.as_std_path());
            for (parent, imports) in imports(&code) {
                for circle in circles_of(&imports) {
                    let package = package.name.as_str();
                    let place = std::iter::once(package).chain(parent.iter().map(String::as_str));
                    let members: Vec<&str> = circle.iter().map(String::as_str).collect();
                    let key = format!("{}: {}", place.collect::<Vec<_>>().join("::"), members.join(", "));
                    circles.insert(key, proof(&imports, &circle));
                }
            }
        }
    }
    let found: Vec<String> = circles.iter().map(|(key, proof)| format!("{key}\n{proof}")).collect();
    assert!(found.is_empty(), "circles between siblings:\n{}", found.join("\n"));
}

/// For each module with children: what they import from each other.
fn imports(code: &Crate) -> BTreeMap<Module, Imports> {
    let mut all: BTreeMap<Module, Imports> = BTreeMap::new();
    for (from, to, written) in code.imports() {
        let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
        if let (Some(importer), Some(imported)) = (from.get(common), to.get(common)) {
            let shown = format!("{} uses {written}", from.join("::"));
            let siblings = all.entry(from[..common].to_vec()).or_default();
            siblings.entry(importer.clone()).or_default().entry(imported.clone()).or_insert(shown);
        }
    }
    all
}

/// Groups of siblings each of which reaches all others of its group.
fn circles_of(imports: &Imports) -> BTreeSet<BTreeSet<String>> {
    let reached = |start: &str| {
        let mut seen = BTreeSet::new();
        let mut pending = vec![start.to_owned()];
        while let Some(name) = pending.pop() {
            for next in imports.get(&name).into_iter().flat_map(BTreeMap::keys) {
                if seen.insert(next.clone()) {
                    pending.push(next.clone());
                }
            }
        }
        seen
    };
    let reach: BTreeMap<&String, BTreeSet<String>> =
        imports.keys().map(|name| (name, reached(name))).collect();
    let circle_of = |name: &String| -> BTreeSet<String> {
        let both = |other: &&String| reach[name].contains(*other) && reach[*other].contains(name);
        reach.keys().copied().filter(both).cloned().collect()
    };
    imports.keys().map(circle_of).filter(|circle| circle.len() > 1).collect()
}

/// The imports that make a circle, one a line.
fn proof(imports: &Imports, circle: &BTreeSet<String>) -> String {
    let inside = |name: &String| circle.contains(name);
    let lines = imports.iter().filter(|(name, _)| inside(name)).flat_map(|(_, targets)| {
        targets.iter().filter(|(target, _)| inside(target)).map(|(_, shown)| format!("    {shown}"))
    });
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn a_circle_is_found_and_a_chain_is_none() {
    let imports = |pairs: &[(&str, &str)]| {
        let mut imports = Imports::new();
        for (from, to) in pairs {
            imports.entry((*from).to_owned()).or_default().insert((*to).to_owned(), String::new());
        }
        imports
    };
    assert!(circles_of(&imports(&[("a", "b"), ("b", "c"), ("a", "c")])).is_empty());
    let circles = circles_of(&imports(&[("a", "b"), ("b", "c"), ("c", "b"), ("d", "a")]));
    assert_eq!(circles, BTreeSet::from([BTreeSet::from(["b".to_owned(), "c".to_owned()])]));
}
