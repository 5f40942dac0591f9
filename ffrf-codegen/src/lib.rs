//! From a reduced flexible body to Rust kernels.
#![forbid(unsafe_code)]

pub mod derive;
pub mod expression;
pub mod fidelity;
pub mod polynomial;
