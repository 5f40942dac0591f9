//! Flexible bodies and mechanisms of run-time size, on the desktop.
//!
//! ```text
//! scene.toml ──scene──▶ Scene ──compose──▶ HostMechanism ──simulate──▶ samples
//! body.ffrf.json ──────▶ HostBody ────────────┘
//! ```
//!
//! The equations are those of the runtime: [`HostBody`] implements its `FlexibleBody` with vectors of run-time size,
//! [`HostMechanism`] its `Assembly`, so joints, forces and integrators are the very same code as on a target. No printing.
//!
//! [`kernels`] runs what the generator would print, without compiling it: to evaluate and verify bodies.
#![forbid(unsafe_code)]

pub mod analysis;
pub mod body;
pub mod kernels;
pub mod mechanism;
pub mod picture;
pub mod scene;
pub mod simulate;
pub mod straight_line;
pub mod tradeoff;

pub use body::{HostBody, HostModal};
pub use mechanism::HostMechanism;
