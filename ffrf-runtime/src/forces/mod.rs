//! What pushes bodies: loads, one file each.

mod gravity;
mod load;
mod marker_load;

pub use gravity::Gravity;
pub use load::Load;
pub use marker_load::{Frame, MarkerLoad};
