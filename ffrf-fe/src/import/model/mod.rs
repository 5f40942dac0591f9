//! From the parts that files supply to one checked model.

mod assemble;

pub(crate) use assemble::{assemble, drop_unused_nodes};
