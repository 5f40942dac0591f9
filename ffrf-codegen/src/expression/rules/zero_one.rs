//! Zero and one elision: what is known to be zero or one costs no operation.

use crate::expression::{Expression, Graph, Node};

pub(super) fn rule(graph: &mut Graph, node: Node) -> Option<Expression> {
    let value = |expression| graph.constant_value(expression);
    match node {
        Node::Add(a, b) => match (value(a), value(b)) {
            (Some(0.0), _) => Some(b),
            (_, Some(0.0)) => Some(a),
            _ => None,
        },
        Node::Subtract(a, b) if a == b => Some(graph.zero()),
        Node::Subtract(a, b) => match (value(a), value(b)) {
            (Some(0.0), _) => Some(graph.negate(b)),
            (_, Some(0.0)) => Some(a),
            _ => None,
        },
        Node::Multiply(a, b) => match (value(a), value(b)) {
            (Some(0.0), _) | (_, Some(0.0)) => Some(graph.zero()),
            (Some(1.0), _) => Some(b),
            (_, Some(1.0)) => Some(a),
            (Some(-1.0), _) => Some(graph.negate(b)),
            (_, Some(-1.0)) => Some(graph.negate(a)),
            _ => None,
        },
        Node::MultiplyAdd(a, b, c) => {
            let is_simple = |x| value(x).is_some_and(|value| value == 0.0 || value.abs() == 1.0);
            (graph.is_zero(c) || is_simple(a) || is_simple(b)).then(|| {
                let product = graph.multiply(a, b);
                graph.add(product, c)
            })
        }
        Node::Divide(a, b) => match (value(a), value(b)) {
            (Some(0.0), None) => Some(graph.zero()),
            (_, Some(1.0)) => Some(a),
            (_, Some(-1.0)) => Some(graph.negate(a)),
            _ => None,
        },
        Node::Constant(_) | Node::Symbol(_) | Node::Negate(_) | Node::SquareRoot(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Input;

    #[test]
    fn zeros_and_ones_cost_nothing() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let zero = graph.zero();
        let one = graph.one();
        assert_eq!(graph.add(x, zero), x);
        assert_eq!(graph.add(zero, x), x);
        assert_eq!(graph.subtract(x, zero), x);
        assert_eq!(graph.multiply(x, zero), zero);
        assert_eq!(graph.multiply(one, x), x);
        assert_eq!(graph.divide(x, one), x);
        assert_eq!(graph.divide(zero, x), zero);
        assert_eq!(graph.subtract(x, x), zero);
        assert_eq!(graph.multiply_add(zero, x, one), one);
        assert_eq!(graph.len(), 3);
    }
}
