//! Inverses: a / c and b / c become a (1 / c) and b (1 / c), one division for all.

use std::collections::HashMap;

use super::rewrite::rewrite;
use crate::expression::{Expression, Graph, Node};
use crate::formulate::Kernel;

/// The kernel with one division for each number that is divided by more than once.
pub(super) fn run(kernel: Kernel) -> Kernel {
    let mut quotients: HashMap<Expression, usize> = HashMap::new();
    let needed = kernel.graph.reachable(&kernel.outputs);
    for (handle, node) in kernel.graph.nodes().take(needed.len()) {
        if let Node::Divide(_, by) = node
            && needed[handle.index()]
        {
            *quotients.entry(by).or_default() += 1;
        }
    }
    rewrite(&kernel, |graph, node, handle| match (kernel.graph.node(handle), node) {
        (Node::Divide(_, old), Node::Divide(dividend, by))
            if quotients.get(&old).is_some_and(|count| *count > 1) =>
        {
            let inverse = inverse(graph, by);
            graph.multiply(dividend, inverse)
        }
        _ => graph.insert(node),
    })
}

fn inverse(graph: &mut Graph, of: Expression) -> Expression {
    let one = graph.one();
    graph.divide(one, of)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::{Input, evaluate};
    use crate::formulate::Draft;
    use crate::formulate::kernels::ELASTIC_ENERGY;

    #[test]
    fn quotients_by_one_number_share_a_division() {
        let mut graph = Draft::default();
        let [x, y, z] = [0, 1, 2].map(|k| graph.symbol(Input::COORDINATES.symbol(k)));
        let outputs = vec![graph.divide(x, z), graph.divide(y, z), graph.divide(x, y)];
        let kernel = Kernel { signature: ELASTIC_ENERGY.signature, mode_count: 3, graph, outputs };
        let shared = run(kernel);
        let divisions = shared.graph.nodes().filter(|(_, node)| matches!(node, Node::Divide(..)));
        assert_eq!(divisions.count(), 2);
        let found = evaluate(&shared.graph, &shared.outputs, |symbol| match symbol {
            crate::expression::Symbol::Input(_, k) => [3.0, 5.0, 4.0][k],
            _ => f64::NAN,
        });
        assert_eq!(found, [0.75, 1.25, 0.6]);
    }
}
