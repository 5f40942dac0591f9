//! The proof can fail: one wrong operation anywhere in the loops is found.

use ffrf_codegen::body::BodyExpressions;
use ffrf_codegen::expression::Graph;
use ffrf_codegen::invariants::{Invariant, Structure};
use ffrf_codegen::layout::Layout;

use crate::loops::whole;
use ffrf_test_kit::proof::mutated::every_mutant_is_found;

#[test]
fn any_wrong_operation_in_the_loops_breaks_the_proof() {
    for modal_mass in [Structure::Diagonal, Structure::Symmetric] {
        let layout = Layout::GENERAL
            .with(Invariant::ModalMass, modal_mass)
            .with(Invariant::LinearLoadStiffness, Structure::Dense);
        let mut graph = Graph::new();
        let body = BodyExpressions::symbolic(&mut graph, 2, &layout);
        let loops = whole::<2, 8, 1, 0, 1>(&mut graph, &body);
        let outputs = [loops.mass_matrix.concat(), loops.quadratic_velocity].concat();
        let mutants = every_mutant_is_found(&graph, &outputs);
        assert!(mutants > 200);
    }
}
