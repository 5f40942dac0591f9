//! Wrong copies of a graph, to show that a proof can fail.

use ffrf_codegen::expression::{Expression, Graph, Node, Symbol};
use ffrf_codegen::polynomial::polynomials_of;

/// A copy of the graph with one node replaced; the other nodes keep their handles.
fn mutated(graph: &Graph, target: Expression, node: Node) -> Graph {
    let mut copy = Graph::new();
    // Nothing is folded, and the replaced node refers to the same operands.
    for (handle, original) in graph.nodes() {
        let inserted = copy.insert(if handle == target { node } else { original });
        if inserted != handle {
            // The replacement equals an earlier node: keep the numbering with a node nobody uses.
            copy.insert(Node::Symbol(Symbol::Intermediate("unused", handle.index())));
        }
    }
    copy
}

/// Puts one wrong sign or operand into every operation that the outputs need, one at a time, and asserts that their
/// polynomials change. Returns how many mutants there were.
pub fn every_mutant_is_found(graph: &Graph, outputs: &[Expression]) -> usize {
    let right = polynomials_of(graph, outputs).unwrap();
    let needed = graph.reachable(outputs);
    let mut mutants = 0;
    for (handle, node) in graph.nodes().filter(|(handle, _)| needed.get(handle.index()) == Some(&true)) {
        let wrong = match node {
            Node::Add(a, b) => Node::Subtract(a, b),
            Node::Subtract(a, b) => Node::Subtract(b, a),
            Node::Negate(a) => Node::Add(a, a),
            Node::Multiply(a, b) if a != b => Node::Multiply(a, a),
            _ => continue,
        };
        let found = polynomials_of(&mutated(graph, handle, wrong), outputs).unwrap();
        assert_ne!(found, right, "{handle:?}: {node:?} as {wrong:?} goes unnoticed");
        mutants += 1;
    }
    eprintln!("{mutants} mutants, all found");
    mutants
}
