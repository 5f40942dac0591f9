//! Compile-time specialised flexible-body dynamics (floating frame of reference formulation).
#![no_std]
#![forbid(unsafe_code)]

pub use ffrf_runtime::*;
