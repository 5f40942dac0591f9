//! The numbered equations of Winkler & Gerstmayr (2018), each a test named after its number.
//!
//! Where print is wrong, the corrected form is asserted and the printed form is shown to fail;
//! `docs/theory` says which those are and what they do to a simulation.
#![allow(clippy::expect_used, reason = "a test fails by panicking, in its helpers too")]

mod appendix;
mod bodies;
mod check;
mod documented;
mod dropped_terms;
mod misprints;
mod nodal;
mod reference;
mod s6_constraints;
mod s7_accelerations;
mod s7_elastic;
mod s7_equations_of_motion;
mod s7_gyroscopic;
mod s7_inertia;
mod s7_mass;
mod s7_projection;
mod s7_volume_integrals;
mod s8_euler_parameters;
mod s8_result;
