//! Mode bases: eigenmodes of K φ = ω² M φ, or shapes that the user supplies.

mod basis;

pub use basis::ModeBasis;
