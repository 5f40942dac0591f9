//! From the parts that files supply to one checked model.

mod assemble;
mod coverage;
mod from_solids;
mod rigid_motion;
mod unused_nodes;

pub(crate) use assemble::assemble;
pub(crate) use from_solids::from_solids;
pub(crate) use unused_nodes::drop_unused_nodes;
