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
    use crate::expression::Input;
    use crate::formulate::Draft;
    use crate::formulate::kernels::ELASTIC_ENERGY;

    #[test]
    fn only_what_the_results_need_stays() {
        let mut graph = Draft::default();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let y = graph.symbol(Input::COORDINATES.symbol(1));
        let dead = graph.multiply(x, y);
        graph.square_root(dead);
        let sum = graph.add(x, y);
        let kernel = Kernel { signature: ELASTIC_ENERGY.signature, mode_count: 2, graph, outputs: vec![sum] };
        assert_eq!(run(kernel).graph.len(), 3);
    }
}
