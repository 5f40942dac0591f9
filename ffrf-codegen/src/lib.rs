//! From a reduced flexible body to Rust kernels.
#![forbid(unsafe_code)]
