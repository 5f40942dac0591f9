//! Forward dynamics is not a polynomial: its accelerations are put back into the equations of motion.

use ffrf_codegen::body::{BodyExpressions, raw_inertia};
use ffrf_codegen::derive::{EulerPoincare, KineticEnergy};
use ffrf_codegen::expression::{Graph, Symbol, evaluate};
use ffrf_codegen::fidelity::Fidelity;
use ffrf_codegen::formulate::State;
use ffrf_codegen::formulate::{Kernel, KernelKind, internal_force};
use ffrf_codegen::layout::{Layout, Structure};
use num_rational::BigRational;
use num_traits::Zero;

use crate::exact::Exact;
use crate::sample::value;

/// M w + Q + [0; 0; K q + D q̇] - force with M and Q derived from the energy and w from the fast kernel.
///
/// In rational arithmetic: an identity of rational functions that holds at random points without any
/// rounding holds everywhere, but for a chance that no one lives to see (Schwartz-Zippel).
fn residual(mode_count: usize, layout: &Layout, fidelity: &Fidelity, seed: u64) -> Vec<BigRational> {
    let exact = |symbol: Symbol| BigRational::from_float(value(symbol, seed)).unwrap();
    let mut graph = Graph::new();
    let raw = raw_inertia(&mut graph, mode_count, layout);
    let energy = KineticEnergy::new(&mut graph, &raw).truncated(&mut graph, fidelity);
    let derived = EulerPoincare::new(&mut graph, energy, mode_count);
    let body = BodyExpressions::symbolic(&mut graph, mode_count, layout).truncated(&mut graph, fidelity);
    let state = State::symbolic(&mut graph, mode_count);
    let internal = internal_force(&mut graph, &body, &state);
    let kernel = Kernel::formulate(KernelKind::ForwardDynamics, graph, &body).unwrap();

    let size = 6 + mode_count;
    let mut outputs = kernel.outputs.clone();
    outputs.extend(&derived.quadratic_velocity);
    outputs.extend(derived.mass_matrix.concat());
    outputs.extend(&internal);
    let results = evaluate(&kernel.graph, &outputs, |symbol| Exact(exact(symbol)));
    let number = |index: usize| results[index].0.clone();
    assert!((0..size).any(|row| !number(row).is_zero()), "at rest: nothing is tested");
    (0..size)
        .map(|row| {
            let inertial = (0..size)
                .map(|column| number(2 * size + row * size + column) * number(column))
                .fold(BigRational::zero(), |sum, product| sum + product);
            let elastic =
                if row < 6 { BigRational::zero() } else { number(2 * size + size * size + row - 6) };
            inertial + number(size + row) + elastic - exact(Symbol::Force(row))
        })
        .collect()
}

fn layouts() -> Vec<Layout> {
    let mut layouts = Vec::new();
    for base in [Layout::GENERAL, Layout::FREE_FREE] {
        for modal_mass in [Structure::Identity, Structure::Diagonal, Structure::Symmetric] {
            layouts.push(Layout { modal_mass, ..base });
        }
    }
    layouts
}

#[test]
fn accelerations_solve_the_derived_equations_exactly() {
    for mode_count in 0..5 {
        for layout in layouts() {
            for fidelity in Fidelity::LEVELS {
                let rest = residual(mode_count, &layout, &fidelity, 1);
                assert!(rest.iter().all(Zero::is_zero), "M = {mode_count}, {layout}, {fidelity}: {rest:?}");
            }
        }
    }
}
