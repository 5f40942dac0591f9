//! The arena: nodes and their handles.

use std::collections::HashMap;

use super::{Constant, Symbol};

/// A handle to a node of one [`Graph`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Expression(pub(crate) u32);

impl Expression {
    /// Position of the node in its graph.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// One operation. Operands are handles to earlier nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Node {
    /// A number.
    Constant(Constant),
    /// An input.
    Symbol(Symbol),
    /// -a
    Negate(Expression),
    /// a + b
    Add(Expression, Expression),
    /// a - b
    Subtract(Expression, Expression),
    /// a b
    Multiply(Expression, Expression),
    /// a b + c, made by the fusion pass only.
    MultiplyAdd(Expression, Expression, Expression),
    /// a / b
    Divide(Expression, Expression),
    /// √a
    SquareRoot(Expression),
}

impl Node {
    /// The operands, in order.
    pub fn operands(&self) -> impl Iterator<Item = Expression> + use<> {
        let operands = match *self {
            Self::Constant(_) | Self::Symbol(_) => [None, None, None],
            Self::Negate(a) | Self::SquareRoot(a) => [Some(a), None, None],
            Self::Add(a, b) | Self::Subtract(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) => {
                [Some(a), Some(b), None]
            }
            Self::MultiplyAdd(a, b, c) => [Some(a), Some(b), Some(c)],
        };
        operands.into_iter().flatten()
    }

    /// Whether the node computes something, other than a change of sign.
    pub fn is_operation(&self) -> bool {
        !matches!(self, Self::Constant(_) | Self::Symbol(_) | Self::Negate(_))
    }
}

/// An arena of nodes, see the [module](super) documentation.
#[derive(Debug, Clone, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    index: HashMap<Node, Expression>,
    rounded_folds: usize,
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there is no node.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The node behind a handle of this graph.
    pub fn node(&self, expression: Expression) -> Node {
        self.nodes[expression.index()]
    }

    /// All nodes with their handles, in index order, which is a topological order.
    pub fn nodes(&self) -> impl DoubleEndedIterator<Item = (Expression, Node)> + '_ {
        self.nodes.iter().enumerate().map(|(index, node)| (Expression(index as u32), *node))
    }

    /// Inserts a node as it is, without folding; an equal node is returned instead if there is one.
    pub fn insert(&mut self, node: Node) -> Expression {
        if let Some(&existing) = self.index.get(&node) {
            return existing;
        }
        let handle = Expression(self.nodes.len() as u32);
        self.nodes.push(node);
        self.index.insert(node, handle);
        handle
    }

    /// The value, if the expression is a constant.
    pub fn constant_value(&self, expression: Expression) -> Option<f64> {
        match self.node(expression) {
            Node::Constant(constant) => Some(constant.value()),
            _ => None,
        }
    }

    /// Whether the expression is the constant 0.
    pub fn is_zero(&self, expression: Expression) -> bool {
        self.constant_value(expression) == Some(0.0)
    }

    /// How many foldings of constants had to round. Zero for graphs over small whole numbers.
    pub fn rounded_folds(&self) -> usize {
        self.rounded_folds
    }

    pub(super) fn count_rounded_fold(&mut self) {
        self.rounded_folds += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::super::Input;
    use super::*;
    use crate::invariants::Invariant;

    #[test]
    fn equal_nodes_are_one_node() {
        let mut graph = Graph::new();
        let x = graph.insert(Node::Symbol(Invariant::Mass.at([])));
        let y = graph.insert(Node::Symbol(Invariant::Mass.at([])));
        assert_eq!(x, y);
        assert_eq!(graph.len(), 1);
    }

    #[test]
    fn operands_stand_before_their_node() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let y = graph.symbol(Input::COORDINATES.symbol(1));
        let product = graph.multiply(x, y);
        let sum = graph.add(product, x);
        graph.square_root(sum);
        for (handle, node) in graph.nodes() {
            assert!(node.operands().all(|operand| operand < handle));
        }
    }
}
