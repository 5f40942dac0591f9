//! Symbolic expressions: an arena of nodes, shared on insertion.
//!
//! A [`Graph`] holds [`Node`]s. An [`Expression`] is a handle to one of them and is `Copy`. A node refers only to
//! nodes that stand before it, so index order is a topological order and there are no cycles. Inserting a node
//! that is already there returns the old handle (hash-consing): equal subexpressions are one node by construction.
//! Building simplifies what it can see locally (`rules`, one file each): constants, zeros, ones, double negation. What folded away costs
//! nothing later.
//!
//! Nodes have no side effects and no order of evaluation beyond their operands. A graph is interpreted by
//! [`evaluate`], differentiated by [`differentiate`], rewritten by `passes` and printed by `emit`.

mod build;
mod constant;
mod differentiate;
mod graph;
mod input;
mod interpret;
mod rules;
mod substitute;
mod symbol;
mod vector;

pub use constant::Constant;
pub use differentiate::differentiate;
pub use graph::{Expression, Graph, Node};
pub(crate) use input::AXES;
pub use input::{Block, Extent, Input};
pub use interpret::{Scalar, evaluate};
pub use substitute::substitute;
pub use symbol::{Indices, Symbol};
pub use vector::{Symmetric3, Vector, cross, dot, negate3, subtract3, sum3, symmetric_times};
