//! From the parts that files supply to one checked model.

mod assemble;
mod coverage;
mod rigid_motion;
mod unused_nodes;

pub(crate) use assemble::assemble;
pub(crate) use unused_nodes::drop_unused_nodes;
