//! The floating frame of reference by its corrected equations (Section 8), written plainly: the reference against
//! which faster kernels and the other formulations are held.
//!
//! What each term of the gyroscopic force means, and when not to use this formulation: `docs/theory/gyroscopic.md` and
//! `docs/theory/validity.md` of the repository.

mod body;
mod motion;

pub use body::FloatingBody;
pub use motion::{FloatingMotion, Pin, RungeKutta};
