//! FMUs by the functions of their library and by their instances; `ffrf-cli/tests/commands/fmu.rs` has whole ones.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod c_sources;
mod in_c;
mod inputs;
mod library;
mod refusals;
mod scenes;
mod states;
