//! What each fuzz target reads, and what must hold of it: an error that can be printed, or a consistent model.
//!
//! The input stands for one file of a small model; the other files are sound. The mutation test of `ffrf-fe` runs the
//! same targets on stable Rust.
#![forbid(unsafe_code)]

mod targets;
mod verdict;

pub use targets::{TARGETS, Target, run};
pub use verdict::Outcome;
