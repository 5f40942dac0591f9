//! No crate may hold unsafe code.

use std::fs;

use crate::workspace::packages;

#[test]
fn every_crate_root_forbids_unsafe_code() {
    for package in packages() {
        for target in
            package.targets.iter().filter(|t| t.is_lib() || t.is_cdylib() || t.is_bin() || t.is_proc_macro())
        {
            let text = fs::read_to_string(&target.src_path).expect("readable crate root");
            assert!(text.contains("#![forbid(unsafe_code)]"), "{} must forbid unsafe code", target.src_path);
        }
    }
}
