//! Mechanisms of random bodies and joints against slow, independent forms and against laws of physics.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod accelerations;
mod bodies;
mod dense;
mod energy;
mod forces;
mod generated_kernels;
mod graphs;
mod hubs;
mod joint_friction;
mod power;
mod reactions;
mod redundancy_report;
mod redundant;
mod rigid_mechanisms;
mod straight_line;
mod supports;
mod tolerances;
mod trees;
mod witness;
