//! Nodes with what their file says about matrices, and the way from labels to rows.

mod lookup;
mod table;

pub(crate) use lookup::NodeLookup;
pub(crate) use table::{ElementTrouble, NodeTable, TroubleKind, compressed};
