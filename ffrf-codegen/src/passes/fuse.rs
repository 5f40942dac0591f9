//! Multiply-add fusion: a b + c as one operation where the product serves nothing else.

use super::rewrite::{rewrite, use_counts};
use crate::expression::{Expression, Graph, Node};
use crate::formulate::Kernel;

/// The kernel with fused products.
pub(super) fn run(kernel: Kernel) -> Kernel {
    let counts = use_counts(&kernel);
    let old = &kernel.graph;
    let fusible = |x: Expression| matches!(old.node(x), Node::Multiply(..)) && counts[x.index()] == 1;
    rewrite(&kernel, |graph, node, handle| match (old.node(handle), node) {
        // The right operand first: in a running sum the left one is the sum so far.
        (Node::Add(_, right), Node::Add(rest, product)) if fusible(right) => {
            fused(graph, product, rest, node, false)
        }
        (Node::Add(left, _), Node::Add(product, rest)) if fusible(left) => {
            fused(graph, product, rest, node, false)
        }
        (Node::Subtract(_, right), Node::Subtract(rest, product)) if fusible(right) => {
            fused(graph, product, rest, node, true)
        }
        (Node::Subtract(left, _), Node::Subtract(product, rest)) if fusible(left) => {
            let minus = graph.negate(rest);
            fused(graph, product, minus, node, false)
        }
        _ => graph.insert(node),
    })
}

/// ± a b + rest
fn fused(graph: &mut Graph, product: Expression, rest: Expression, node: Node, negative: bool) -> Expression {
    match graph.node(product) {
        Node::Multiply(a, b) if negative => {
            // A constant takes the sign for nothing.
            let (a, b) = if graph.constant_value(b).is_some() { (b, a) } else { (a, b) };
            let minus = graph.negate(a);
            graph.insert(Node::MultiplyAdd(minus, b, rest))
        }
        Node::Multiply(a, b) => graph.insert(Node::MultiplyAdd(a, b, rest)),
        _ => graph.insert(node),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::{Input, Symbol, evaluate};
    use crate::formulate::Draft;
    use crate::formulate::kernels::ELASTIC_ENERGY;

    #[test]
    fn products_fuse_with_the_sum_that_alone_uses_them() {
        let mut graph = Draft::default();
        let [x, y, z] = [0, 1, 2].map(|k| graph.symbol(Input::COORDINATES.symbol(k)));
        let product = graph.multiply(x, y);
        let plus = graph.add(z, product);
        let other = graph.multiply(x, z);
        let minus = graph.subtract(plus, other);
        let shared = graph.multiply(y, z);
        let outputs = vec![minus, shared, graph.add(shared, x)];
        let kernel = Kernel { signature: ELASTIC_ENERGY.signature, mode_count: 3, graph, outputs };
        let value = |symbol| match symbol {
            Symbol::Input(Input::COORDINATES, k) => [2.0, 3.0, 5.0][k],
            _ => f64::NAN,
        };
        let before = evaluate(&kernel.graph, &kernel.outputs, value);
        let kernel = super::super::dead_code::run(run(kernel));
        assert_eq!(evaluate(&kernel.graph, &kernel.outputs, value), before);
        let count = |wanted: fn(&Node) -> bool| kernel.graph.nodes().filter(|(_, node)| wanted(node)).count();
        assert_eq!(count(|node| matches!(node, Node::MultiplyAdd(..))), 2);
        assert_eq!(count(|node| matches!(node, Node::Multiply(..))), 1);
    }
}
