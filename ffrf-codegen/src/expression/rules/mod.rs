//! What is simplified when an expression is built, one file each, in their order.
//!
//! A rule sees one node whose operands are built already and gives a simpler expression for it, or nothing. Equal
//! subexpressions need no rule: [`Graph::insert`] gives the same handle for the same node. Together they are the first
//! passes; those that need the whole graph follow in [`crate::passes`].

mod fold;
mod sign;
mod zero_one;

use super::{Expression, Graph, Node};

/// A simpler expression for a node, if there is one.
type Rule = fn(&mut Graph, Node) -> Option<Expression>;

/// Every rule, in order.
const RULES: [Rule; 3] = [fold::rule, zero_one::rule, sign::rule];

impl Graph {
    /// The expression of a node: as simple as the rules make it, with the operands of sums and products in index order.
    pub(super) fn simplified(&mut self, node: Node) -> Expression {
        for rule in RULES {
            if let Some(simpler) = rule(self, node) {
                return simpler;
            }
        }
        self.insert(match node {
            Node::Add(a, b) => Node::Add(a.min(b), a.max(b)),
            Node::Multiply(a, b) => Node::Multiply(a.min(b), a.max(b)),
            other => other,
        })
    }
}
