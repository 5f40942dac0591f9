//! Statics, linearisation, eigenfrequencies, frequency response and Campbell diagrams of a mechanism.
//!
//! ```text
//! Scene ──equilibrium──▶ state ──linearise──▶ StateSpace (A, B, C, D) ──▶ Modes, frequency response
//!   └──────────────────────campbell: the same about steady rotations──────────▶ CampbellPoint
//! ```
//!
//! Every derivative is exact: the equations of the simulation itself, in dual numbers. Coordinates are minimal: an orthonormal
//! basis (in the kinetic energy) of the motions that the joints leave.

mod campbell;
mod eigen;
mod equilibrium;
mod error;
mod evaluate;
mod response;
mod spin;
mod stable_step;
mod state_space;
mod tangent;
mod whirl;

pub use campbell::{Campbell, CampbellPoint, SpinTarget, campbell};
pub use eigen::{Eigenmode, eigenmodes};
pub use equilibrium::{Equilibrium, equilibrium};
pub use error::AnalysisError;
pub use response::frequency_response;
pub use spin::SpinFrame;
pub use stable_step::largest_explicit_step;
pub use state_space::{Drives, StateSpace, linearise};
pub use whirl::Whirl;
