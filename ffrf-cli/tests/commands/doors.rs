//! Three doors, one generator: what the command prints is what the generator makes of the same choices.
//!
//! The macro is held against the same table in `ffrf-macros/src/expand.rs`.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use crate::workbench::Workbench;
use ffrf_codegen::{GeneratedCode, generate, generate_with_layout};
use ffrf_model::ReducedBody;
use ffrf_test_kit::doors;

#[track_caller]
fn same_code(printed: &str, expected: &GeneratedCode, flags: &str) {
    assert_eq!(printed, expected.text, "{flags}");
    // The type of `tokens` without its name: proc-macro2 is no dependency of the command.
    let mut read_back = expected.tokens.clone();
    read_back = printed.parse().unwrap_or(read_back);
    assert_eq!(read_back.to_string(), expected.tokens.to_string(), "{flags}");
}

#[test]
fn the_command_prints_what_the_generator_makes_of_a_model() {
    let bench = Workbench::new();
    let text =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(doors::MODEL));
    let text = text.unwrap();
    bench.write(doors::MODEL, &text);
    let model = ReducedBody::from_json(&text).unwrap();
    let mut different = std::collections::BTreeSet::new();
    for door in doors::with_model() {
        let printed = bench.run(&format!("generate {} --name Part {}", doors::MODEL, door.flags)).succeeded();
        same_code(&printed, &generate(&model, &door.options).unwrap(), door.flags);
        different.insert(printed);
    }
    // Only the two spelled-out defaults print what others print.
    assert_eq!(different.len(), doors::with_model().len() - 2);
}

#[test]
fn the_command_prints_what_the_generator_makes_of_a_layout() {
    let bench = Workbench::new();
    for (modes, layout, door) in doors::with_layout() {
        let printed = bench.run(&format!("generate --name Part {}", door.flags)).succeeded();
        same_code(&printed, &generate_with_layout(modes, &layout, &door.options).unwrap(), door.flags);
    }
    let contradiction = "generate --modes 2 --layout mode_mode_moment=antisymmetric";
    bench.run(contradiction).failed(1, &["mode_mode_moment cannot be antisymmetric", "Θ_ff"]);
}

#[test]
fn inspect_counts_the_fidelity_that_it_is_given() {
    let bench = Workbench::new();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(doors::MODEL);
    bench.write(doors::MODEL, &std::fs::read_to_string(path).unwrap());
    let operations = |flags: &str| {
        let text = bench.run(&format!("inspect {} {flags}", doors::MODEL)).succeeded();
        let line = text.lines().find(|line| line.trim_start().starts_with("forward_dynamics")).unwrap();
        line.split_whitespace().nth(1).unwrap().parse::<usize>().unwrap()
    };
    assert_eq!(operations("--fidelity full"), operations(""));
    assert!(operations("--fidelity linear") < operations(""));
    assert!(operations("--fidelity constant") < operations("--fidelity linear"));
    let special = bench.run(&format!("inspect {} --layout-tolerance 0.999", doors::MODEL)).succeeded();
    assert_ne!(special, bench.run(&format!("inspect {}", doors::MODEL)).succeeded());
}
