//! What pushes bodies: every [`Load`](crate::Load), one file each.

mod bushing;
mod gravity;
mod marker_load;
mod spring;
mod torsion_spring;

pub use bushing::Bushing;
pub use gravity::Gravity;
pub use marker_load::{Frame, MarkerLoad};
pub use spring::Spring;
pub use torsion_spring::{TorsionSpring, relative_angle};
