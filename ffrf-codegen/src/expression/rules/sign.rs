//! Changes of sign travel outwards, so that more subexpressions meet as one: (-a) b is -(a b), a + (-b) is a - b.

use crate::expression::{Expression, Graph, Node};

pub(super) fn rule(graph: &mut Graph, node: Node) -> Option<Expression> {
    match node {
        Node::Negate(a) => match graph.node(a) {
            Node::Negate(inner) => Some(inner),
            Node::Subtract(left, right) => Some(graph.subtract(right, left)),
            _ => None,
        },
        Node::Add(a, b) => match (graph.node(a), graph.node(b)) {
            (Node::Negate(left), Node::Negate(right)) => {
                let sum = graph.add(left, right);
                Some(graph.negate(sum))
            }
            (Node::Negate(left), _) => Some(graph.subtract(b, left)),
            (_, Node::Negate(right)) => Some(graph.subtract(a, right)),
            _ => None,
        },
        Node::Subtract(a, b) => match (graph.node(a), graph.node(b)) {
            (Node::Negate(left), Node::Negate(right)) => Some(graph.subtract(right, left)),
            (_, Node::Negate(right)) => Some(graph.add(a, right)),
            (Node::Negate(left), _) => {
                let sum = graph.add(left, b);
                Some(graph.negate(sum))
            }
            _ => None,
        },
        Node::Multiply(a, b) => match (graph.node(a), graph.node(b)) {
            (Node::Negate(left), Node::Negate(right)) => Some(graph.multiply(left, right)),
            (Node::Negate(inner), Node::Constant(constant))
            | (Node::Constant(constant), Node::Negate(inner)) => {
                let factor = graph.constant(-constant.value());
                Some(graph.multiply(inner, factor))
            }
            (Node::Negate(left), _) => {
                let product = graph.multiply(left, b);
                Some(graph.negate(product))
            }
            (_, Node::Negate(right)) => {
                let product = graph.multiply(a, right);
                Some(graph.negate(product))
            }
            _ => None,
        },
        Node::Divide(a, b) => match (graph.node(a), graph.node(b)) {
            (Node::Negate(left), Node::Negate(right)) => Some(graph.divide(left, right)),
            (Node::Negate(left), _) => {
                let quotient = graph.divide(left, b);
                Some(graph.negate(quotient))
            }
            (_, Node::Negate(right)) => {
                let quotient = graph.divide(a, right);
                Some(graph.negate(quotient))
            }
            _ => None,
        },
        Node::Constant(_) | Node::Symbol(_) | Node::MultiplyAdd(..) | Node::SquareRoot(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Input;

    #[test]
    fn signs_travel_outwards() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let y = graph.symbol(Input::COORDINATES.symbol(1));
        let minus_x = graph.negate(x);
        let minus_y = graph.negate(y);
        let product = graph.multiply(x, y);
        assert_eq!(graph.negate(minus_x), x);
        assert_eq!(graph.multiply(minus_x, minus_y), product);
        let negative = graph.multiply(minus_x, y);
        assert_eq!(graph.node(negative), Node::Negate(product));
        let difference = graph.add(x, minus_y);
        assert_eq!(graph.node(difference), Node::Subtract(x, y));
        let reverse = graph.negate(difference);
        assert_eq!(graph.node(reverse), Node::Subtract(y, x));
        let scaled = graph.scale(2.0, x);
        let scaled_negative = graph.scale(-2.0, minus_x);
        assert_eq!(scaled, scaled_negative);
    }
}
