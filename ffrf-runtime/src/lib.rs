//! `no_std` runtime for generated flexible bodies: the [`FlexibleBody`] trait, states, rotations, integrators.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(test, feature = "std"))]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!(
    "ffrf-runtime needs float functions: turn on the feature `std` (hosts) or `libm` (targets without one)"
);

mod flexible_body;
#[doc(hidden)]
pub mod generated_support;
mod marker;

pub use flexible_body::{EquationsOfMotion, FlexibleBody};
pub use marker::Marker;
pub use nalgebra;
