//! The floating frame of reference by its corrected equations (Section 8), written plainly: the reference against
//! which faster kernels and the other formulations are held.
//!
#![doc = include_str!("../../../../docs/theory/gyroscopic.md")]
#![doc = include_str!("../../../../docs/theory/validity.md")]

mod body;
mod motion;

pub use body::FloatingBody;
pub use motion::{FloatingMotion, Pin, RungeKutta};
