//! Compile-time specialised flexible-body dynamics (floating frame of reference formulation).
//!
//! A finite-element model, reduced to a few modes by the `ffrf` command, becomes a Rust type: [`flexible_body!`]
//! reads the model while your crate compiles and generates mass matrix, quadratic velocity vector and forward
//! dynamics as straight-line code on the stack, without allocation, panics or `unsafe`.
//!
//! [`mechanism!`] composes such bodies, rigid ones, joints, drives, forces and sensors into one type of static size.
//!
//! The facade re-exports the runtime ([`FlexibleBody`], states, integrators), the macros, and [`nalgebra`].
#![no_std]
#![forbid(unsafe_code)]

pub use ffrf_macros::{flexible_body, mechanism};
pub use ffrf_runtime::*;

#[doc(hidden)]
pub use ffrf_runtime::generated_support;

/// The README's example, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The examples of the page on mechanisms, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../docs/mechanisms.md")]
struct Mechanisms;

/// The example of a family, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../docs/tradeoff.md")]
struct Tradeoff;
