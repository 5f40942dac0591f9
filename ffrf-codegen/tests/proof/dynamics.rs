//! Forward dynamics is not a polynomial: its accelerations are put back into the equations of motion.

use ffrf_codegen::body::{BodyExpressions, raw_inertia};
use ffrf_codegen::derive::{EulerPoincare, KineticEnergy};
use ffrf_codegen::expression::Graph;
use ffrf_codegen::fidelity::Fidelity;
use ffrf_codegen::formulate::kernels::FORWARD_DYNAMICS;
use ffrf_codegen::formulate::{Kernel, State, internal_force};
use ffrf_codegen::invariants::Invariant;
use ffrf_codegen::layout::{Layout, Structure};
use num_rational::BigRational;
use num_traits::Zero;

use ffrf_test_kit::proof::residual::residual;

/// What the accelerations of the fast kernel leave of the derived equations of motion.
fn rest(mode_count: usize, layout: &Layout, fidelity: &Fidelity) -> Vec<BigRational> {
    let mut graph = Graph::new();
    let raw = raw_inertia(&mut graph, mode_count, layout);
    let energy = KineticEnergy::new(&mut graph, &raw).truncated(&mut graph, fidelity);
    let derived = EulerPoincare::new(&mut graph, energy, mode_count);
    let body = BodyExpressions::symbolic(&mut graph, mode_count, layout).truncated(&mut graph, fidelity);
    let state = State::symbolic(&mut graph, mode_count);
    let internal = internal_force(&mut graph, &body, &state);
    let kernel = Kernel::formulate(&FORWARD_DYNAMICS, graph, &body).unwrap();
    residual(&kernel.graph, &derived, &internal, &kernel.outputs, 1)
}

fn layouts() -> Vec<Layout> {
    let mut layouts = Vec::new();
    for base in [Layout::GENERAL, Layout::FREE_FREE] {
        for modal_mass in [Structure::Identity, Structure::Diagonal, Structure::Symmetric] {
            let base = base.with(Invariant::ModalMass, modal_mass);
            layouts.extend([base, base.stiffened()]);
        }
    }
    layouts
}

#[test]
fn accelerations_solve_the_derived_equations_exactly() {
    for mode_count in 0..5 {
        for layout in layouts() {
            for fidelity in Fidelity::LEVELS {
                let rest = rest(mode_count, &layout, &fidelity);
                assert!(rest.iter().all(Zero::is_zero), "M = {mode_count}, {layout}, {fidelity}: {rest:?}");
            }
        }
    }
}
