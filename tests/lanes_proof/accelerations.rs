//! The accelerations put back into the derived equations of motion, in rational arithmetic.

use ffrf_codegen::body::{BodyExpressions, raw_inertia};
use ffrf_codegen::derive::{EulerPoincare, KineticEnergy};
use ffrf_codegen::expression::Graph;
use ffrf_codegen::fidelity::Fidelity;
use ffrf_codegen::formulate::{State, internal_force};
use ffrf_codegen::layout::Layout;
use num_rational::BigRational;
use num_traits::Zero;

use crate::loops::{Compiled, whole};
use crate::{fidelities, layouts};
use ffrf_test_kit::proof::residual::residual;

/// What the accelerations of the loops leave of the derived equations of motion.
fn rest(modes: usize, compiled: Compiled, layout: &Layout, fidelity: &Fidelity) -> Vec<BigRational> {
    let mut graph = Graph::new();
    let raw = raw_inertia(&mut graph, modes, layout);
    let energy = KineticEnergy::new(&mut graph, &raw).truncated(&mut graph, fidelity);
    let derived = EulerPoincare::new(&mut graph, energy, modes);
    let body = BodyExpressions::symbolic(&mut graph, modes, layout).truncated(&mut graph, fidelity);
    let state = State::symbolic(&mut graph, modes);
    let internal = internal_force(&mut graph, &body, &state);
    let loops = compiled(&mut graph, &body);
    residual(&graph, &derived, &internal, &loops.acceleration, 1)
}

#[test]
fn accelerations_of_the_loops_solve_the_derived_equations_exactly() {
    let compiled: [(usize, Compiled); 4] = [
        (1, whole::<1, 7, 1, 0, 1>),
        (2, whole::<2, 8, 1, 0, 1>),
        (4, whole::<4, 10, 1, 0, 1>),
        (5, whole::<5, 11, 2, 1, 0>),
    ];
    for (modes, compiled) in compiled {
        for layout in layouts() {
            for fidelity in fidelities() {
                let rest = rest(modes, compiled, &layout, &fidelity);
                assert!(rest.iter().all(Zero::is_zero), "M = {modes}, {layout}, {fidelity}: {rest:?}");
            }
        }
    }
}
