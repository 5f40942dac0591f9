//! Constant folding: an operation on numbers is a number. Whether it had to be rounded is counted.

use crate::expression::{Expression, Graph, Node};

pub(super) fn rule(graph: &mut Graph, node: Node) -> Option<Expression> {
    let value = |expression| graph.constant_value(expression);
    let (folded, exact) = match node {
        Node::Negate(a) => (-value(a)?, true),
        Node::Add(a, b) => sum(value(a)?, value(b)?),
        Node::Subtract(a, b) => sum(value(a)?, -value(b)?),
        Node::Multiply(a, b) => product(value(a)?, value(b)?),
        Node::MultiplyAdd(a, b, c) => {
            // The product alone may be a number.
            value(a).and(value(b))?;
            let product = graph.multiply(a, b);
            return Some(graph.add(product, c));
        }
        Node::Divide(a, b) => quotient(value(a)?, value(b)?)?,
        Node::SquareRoot(a) => root(value(a)?)?,
        Node::Constant(_) | Node::Symbol(_) => return None,
    };
    if !exact {
        graph.count_rounded_fold();
    }
    Some(graph.constant(folded))
}

fn sum(left: f64, right: f64) -> (f64, bool) {
    let sum = left + right;
    let shadow = sum - left;
    (sum, (left - (sum - shadow)) + (right - shadow) == 0.0)
}

fn product(left: f64, right: f64) -> (f64, bool) {
    let product = left * right;
    (product, left.mul_add(right, -product) == 0.0)
}

/// Nothing for a division by zero: the validator refuses it with its place.
fn quotient(left: f64, right: f64) -> Option<(f64, bool)> {
    let quotient = left / right;
    (right != 0.0).then(|| (quotient, quotient.mul_add(-right, left) == 0.0))
}

/// Nothing for a negative number.
fn root(value: f64) -> Option<(f64, bool)> {
    let root = value.sqrt();
    (value >= 0.0).then(|| (root, root.mul_add(root, -value) == 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_fold_and_rounding_is_counted() {
        let mut graph = Graph::new();
        let half = graph.constant(0.5);
        let three = graph.constant(3.0);
        let exact = graph.multiply(half, three);
        assert_eq!(graph.constant_value(exact), Some(1.5));
        assert_eq!(graph.rounded_folds(), 0);
        let tenth = graph.constant(0.1);
        let rounded = graph.multiply(tenth, three);
        assert_eq!(graph.constant_value(rounded), Some(0.1 * 3.0));
        assert_eq!(graph.rounded_folds(), 1);
        let four = graph.constant(4.0);
        let root = graph.square_root(four);
        assert_eq!(graph.constant_value(root), Some(2.0));
        assert_eq!(graph.rounded_folds(), 1);
    }

    #[test]
    fn what_has_no_value_is_left_alone() {
        let mut graph = Graph::new();
        let (zero, minus_one) = (graph.zero(), graph.constant(-1.0));
        let quotient = graph.divide(minus_one, zero);
        let root = graph.square_root(minus_one);
        assert_eq!(graph.node(quotient), Node::Divide(minus_one, zero));
        assert_eq!(graph.node(root), Node::SquareRoot(minus_one));
    }
}
