//! Common factors: a b + a c becomes a (b + c) where both products serve nothing else.

use super::rewrite::{rewrite, use_counts};
use crate::expression::{Expression, Graph, Node};
use crate::formulate::Kernel;

/// The kernel with one product less for each common factor.
pub(super) fn run(kernel: Kernel) -> Kernel {
    let counts = use_counts(&kernel);
    let old = &kernel.graph;
    // Decided on the old graph: there each product's number of uses is known.
    let single_product = |x: Expression| matches!(old.node(x), Node::Multiply(..)) && counts[x.index()] == 1;
    rewrite(&kernel, |graph, node, handle| {
        let sides = match old.node(handle) {
            Node::Add(a, b) | Node::Subtract(a, b) => [a, b],
            _ => return graph.insert(node),
        };
        if !sides.into_iter().all(single_product) {
            return graph.insert(node);
        }
        match node {
            Node::Add(a, b) => factored(graph, a, b, Graph::add),
            Node::Subtract(a, b) => factored(graph, a, b, Graph::subtract),
            _ => None,
        }
        .unwrap_or_else(|| graph.insert(node))
    })
}

/// a (b ± c) for the products a b and a c, if they share a factor.
fn factored(
    graph: &mut Graph,
    left: Expression,
    right: Expression,
    combine: fn(&mut Graph, Expression, Expression) -> Expression,
) -> Option<Expression> {
    let (Node::Multiply(a, b), Node::Multiply(c, d)) = (graph.node(left), graph.node(right)) else {
        return None;
    };
    let (common, first, second) = match () {
        () if a == c => (a, b, d),
        () if a == d => (a, b, c),
        () if b == c => (b, a, d),
        () if b == d => (b, a, c),
        () => return None,
    };
    let inner = combine(graph, first, second);
    Some(graph.multiply(common, inner))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::{Input, Symbol, evaluate};
    use crate::formulate::Draft;
    use crate::formulate::kernels::ELASTIC_ENERGY;

    #[test]
    fn a_common_factor_saves_a_product() {
        let mut graph = Draft::default();
        let [x, y, z] = [0, 1, 2].map(|k| graph.symbol(Input::COORDINATES.symbol(k)));
        let left = graph.multiply(x, y);
        let right = graph.multiply(z, x);
        let difference = graph.subtract(left, right);
        let kernel =
            Kernel { signature: ELASTIC_ENERGY.signature, mode_count: 3, graph, outputs: vec![difference] };
        let factored = super::super::dead_code::run(run(kernel));
        let products = factored.graph.nodes().filter(|(_, node)| matches!(node, Node::Multiply(..)));
        assert_eq!(products.count(), 1);
        let value = |symbol| match symbol {
            Symbol::Input(Input::COORDINATES, k) => [2.0, 3.0, 5.0][k],
            _ => f64::NAN,
        };
        assert_eq!(evaluate(&factored.graph, &factored.outputs, value), [2.0 * (3.0 - 5.0)]);
    }
}
