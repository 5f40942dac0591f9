//! No crate may hold unsafe code, but for the borders to C and to a trait with the word in its signatures, which are modules
//! of their own.

use std::fs;

use crate::workspace::{packages, root, source_files};

/// Crates with a border, their sources, and the folder or file that it is.
const BORDERS: [(&str, &str, &str); 3] = [
    ("ffrf-fmu", "ffrf-fmu/src", "ffrf-fmu/src/ffi"),
    ("ffrf-c-interface", "examples/c_interface/src", "examples/c_interface/src/border"),
    ("ffrf-trace", "ffrf-trace/src", "ffrf-trace/src/register.rs"),
];

/// Code with the word `unsafe`, without what comments and texts say.
fn has_unsafe(text: &str) -> bool {
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    code.flat_map(|line| line.split("//").next())
        .any(|line| line.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == "unsafe"))
}

#[test]
fn every_crate_root_forbids_unsafe_code() {
    for package in packages() {
        for target in
            package.targets.iter().filter(|t| t.is_lib() || t.is_cdylib() || t.is_bin() || t.is_proc_macro())
        {
            let text = fs::read_to_string(&target.src_path).expect("readable crate root");
            if BORDERS.iter().any(|(name, ..)| *name == package.name.as_str()) {
                let manifest = fs::read_to_string(&package.manifest_path).expect("readable manifest");
                for lint in ["unsafe_code = \"deny\"", "unsafe_op_in_unsafe_fn = \"deny\""] {
                    assert!(manifest.contains(lint), "{} must say {lint}", package.manifest_path);
                }
                continue;
            }
            assert!(text.contains("#![forbid(unsafe_code)]"), "{} must forbid unsafe code", target.src_path);
        }
    }
}

#[test]
fn unsafe_code_stands_at_the_borders_alone() {
    let mut seen = 0;
    for (_, sources, border) in BORDERS {
        let sources = root().join(sources);
        for path in source_files().iter().filter(|path| path.starts_with(&sources)) {
            let text = fs::read_to_string(path).expect("readable file");
            let inside = path.strip_prefix(root()).is_ok_and(|path| path.starts_with(border));
            assert!(inside || !has_unsafe(&text), "{}: unsafe code outside {border}", path.display());
            seen += usize::from(inside && has_unsafe(&text));
        }
    }
    assert!(seen > 0, "the borders hold no unsafe code: they need no exception");
}

#[test]
fn unsafe_code_is_seen_and_talk_of_it_is_not() {
    assert!(has_unsafe("fn f() {\n    let x = unsafe { g() };\n}"));
    assert!(!has_unsafe("//! No unsafe here.\n#![forbid(unsafe_code)]\nfn f() {} // unsafe"));
}
