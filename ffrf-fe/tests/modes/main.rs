//! Modes, component modes of interfaces, and reduction: reference bodies, two solvers against each other, and structures with
//! known frequencies.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests may panic")]

mod beams;
mod component_modes;
mod conrod;
mod many;
mod markers;
mod materials;
mod meshes;
mod progress;
mod reference;
mod reference_bodies;
mod refusals;
mod solvers;
mod tolerances;
mod units;
