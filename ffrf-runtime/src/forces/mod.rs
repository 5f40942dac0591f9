//! What pushes bodies: loads, one file each.

mod bushing;
mod gravity;
mod load;
mod marker_load;
mod spring;
mod torsion_spring;

pub use bushing::Bushing;
pub use gravity::Gravity;
pub use load::Load;
pub use marker_load::{Frame, MarkerLoad};
pub use spring::Spring;
pub use torsion_spring::{TorsionSpring, relative_angle};
