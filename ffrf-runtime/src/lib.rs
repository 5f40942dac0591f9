//! `no_std` runtime for generated flexible bodies: the [`FlexibleBody`] trait, states, rotations, integrators.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(test, feature = "std"))]
extern crate std;

mod flexible_body;
mod marker;

pub use flexible_body::{EquationsOfMotion, FlexibleBody};
pub use marker::Marker;
pub use nalgebra;
