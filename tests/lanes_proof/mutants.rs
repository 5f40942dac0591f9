//! The proof can fail: one wrong operation anywhere in the loops is found.

use ffrf_codegen::body::BodyExpressions;
use ffrf_codegen::expression::{Expression, Graph, Node, Symbol};
use ffrf_codegen::layout::{Layout, Structure};
use ffrf_codegen::polynomial::polynomials_of;

use crate::loops::whole;

/// A copy of the graph with one node replaced; the other nodes keep their handles.
fn mutated(graph: &Graph, target: Expression, node: Node) -> Graph {
    let mut copy = Graph::new();
    for (handle, original) in graph.nodes() {
        let inserted = copy.insert(if handle == target { node } else { original });
        if inserted != handle {
            // The replacement equals an earlier node: keep the numbering with a node nobody uses.
            copy.insert(Node::Symbol(Symbol::Intermediate("unused", handle.index())));
        }
    }
    copy
}

#[test]
fn any_wrong_operation_in_the_loops_breaks_the_proof() {
    let layout = Layout { modal_mass: Structure::Diagonal, ..Layout::GENERAL };
    let mut graph = Graph::new();
    let body = BodyExpressions::symbolic(&mut graph, 2, &layout);
    let loops = whole::<2, 8, 1, 0, 1>(&mut graph, &body);
    let outputs = [loops.mass_matrix.concat(), loops.quadratic_velocity].concat();
    let right = polynomials_of(&graph, &outputs).unwrap();
    let needed = graph.reachable(&outputs);
    let mut mutants = 0;
    for (handle, node) in graph.nodes().filter(|(handle, _)| needed.get(handle.index()) == Some(&true)) {
        let wrong = match node {
            Node::Add(a, b) => Node::Subtract(a, b),
            Node::Subtract(a, b) => Node::Subtract(b, a),
            Node::Negate(a) => Node::Add(a, a),
            Node::Multiply(a, b) if a != b => Node::Multiply(a, a),
            _ => continue,
        };
        let copy = mutated(&graph, handle, wrong);
        assert_ne!(polynomials_of(&copy, &outputs).unwrap(), right, "{node:?} as {wrong:?} goes unnoticed");
        mutants += 1;
    }
    eprintln!("{mutants} mutants, all found");
    assert!(mutants > 200);
}
