//! Drops what no result needs.

use super::rewrite::rewrite;
use crate::formulate::Kernel;

/// The kernel with reachable nodes only.
pub(super) fn run(kernel: Kernel) -> Kernel {
    rewrite(&kernel, |graph, node, _| graph.insert(node))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::{Graph, Symbol};
    use crate::formulate::KernelKind;

    #[test]
    fn only_what_the_results_need_stays() {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Coordinate(0));
        let y = graph.symbol(Symbol::Coordinate(1));
        let dead = graph.multiply(x, y);
        graph.square_root(dead);
        let sum = graph.add(x, y);
        let kernel = Kernel { kind: KernelKind::ElasticEnergy, mode_count: 2, graph, outputs: vec![sum] };
        assert_eq!(run(kernel).graph.len(), 3);
    }
}
