//! What pushes bodies: every [`Load`](crate::Load), one file each.

mod actuator;
mod bushing;
mod constant_wrench;
mod effort;
mod force_element;
mod friction;
mod gravity;
mod marker_load;
mod soft_row;
mod spring;
mod torsion_spring;

pub use actuator::Actuator;
pub use bushing::Bushing;
pub use constant_wrench::ConstantWrench;
pub use effort::Effort;
pub use force_element::ForceElement;
pub use friction::Friction;
pub use gravity::Gravity;
pub use marker_load::{Frame, MarkerLoad};
pub use soft_row::SoftRow;
pub use spring::Spring;
pub use torsion_spring::{TorsionSpring, relative_angle};
