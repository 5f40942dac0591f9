//! Proofs that the equations of motion are right, as identities of polynomials with symbolic invariants.
//!
//! The chain: the energy is that of a mass point (`energy`), the derived equations obey the laws that any
//! energy implies (`laws`), written-out formulas equal the derived ones and each misprint of the paper does
//! not (`misprints`), and the fast kernels equal the derived ones (`kernels`).

// The allowance for tests in clippy.toml covers functions marked as tests, not the helpers beside them.
#![allow(clippy::unwrap_used)]

mod dynamics;
mod energy;
mod formulas;
mod jacobians;
mod kernels;
mod laws;
mod misprints;
mod passes;
mod tolerances;
