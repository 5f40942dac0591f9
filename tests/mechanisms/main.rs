//! Mechanisms that `mechanism!` composes, at work.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod bodies;
mod chain;
mod kinds;
mod misassembled;
mod pendulum;
mod saved;
mod scalars;
mod scene;
mod slider_crank;
mod stack;
mod trees;
