//! Mechanisms that `mechanism!` composes, at work.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod accelerations;
mod arrays;
mod bodies;
mod chain;
mod energies;
mod friction;
mod kinds;
mod misassembled;
mod pendulum;
mod planned;
mod saved;
mod scalars;
mod scene;
mod slider_crank;
mod stack;
mod stiff_supports;
mod straight_line;
mod treatments;
mod trees;
mod user_forces;
