//! Constrained accelerations of a whole mechanism in straight-line code.
//!
//! ```text
//! Scene ──cast──▶ HostMechanism<Traced> ──rates, implicit rates──▶ tape ──▶ ArrayFunction ──ffrf-codegen──▶ Rust
//! ```
//!
//! The runtime's own equations are run once on numbers that write down what is computed with them, so nothing is formulated a
//! second time. All constants of the scene are in the code; the state and the drives are its arguments, and so
//! is what a linearly implicit stage has besides. Numbers of the state that never move are constants as well ([`Motions`]).

mod accelerations;
mod arguments;
mod error;
mod implicit_accelerations;
mod motions;
mod projection;
mod reachable;

pub use accelerations::accelerations;
pub use error::StraightLineError;
pub use implicit_accelerations::implicit_accelerations;
pub use motions::Motions;
pub use projection::{implicit_projection, projection};
