//! The accelerations put back into the derived equations of motion, in rational arithmetic.

use ffrf_codegen::body::{BodyExpressions, raw_inertia};
use ffrf_codegen::derive::{EulerPoincare, KineticEnergy};
use ffrf_codegen::expression::{Graph, Symbol, evaluate};
use ffrf_codegen::fidelity::Fidelity;
use ffrf_codegen::formulate::{State, internal_force};
use ffrf_codegen::layout::Layout;
use num_rational::BigRational;
use num_traits::Zero;

use crate::exact::Exact;
use crate::loops::{Compiled, whole};
use crate::sample::value;
use crate::{fidelities, layouts};

/// M w + Q + [0; 0; K q + D q̇] - force with M and Q derived from the energy and w from the loops.
///
/// An identity of rational functions that holds at random points without any rounding holds everywhere, but for a
/// chance that no one lives to see (Schwartz-Zippel).
fn residual(modes: usize, compiled: Compiled, layout: &Layout, fidelity: &Fidelity) -> Vec<BigRational> {
    let exact = |symbol: Symbol| BigRational::from_float(value(symbol, 1)).unwrap();
    let mut graph = Graph::new();
    let raw = raw_inertia(&mut graph, modes, layout);
    let energy = KineticEnergy::new(&mut graph, &raw).truncated(&mut graph, fidelity);
    let derived = EulerPoincare::new(&mut graph, energy, modes);
    let body = BodyExpressions::symbolic(&mut graph, modes, layout).truncated(&mut graph, fidelity);
    let state = State::symbolic(&mut graph, modes);
    let internal = internal_force(&mut graph, &body, &state);
    let loops = compiled(&mut graph, &body);

    let size = 6 + modes;
    let mut outputs = loops.acceleration;
    outputs.extend(&derived.quadratic_velocity);
    outputs.extend(derived.mass_matrix.concat());
    outputs.extend(&internal);
    let results = evaluate(&graph, &outputs, |symbol| Exact(exact(symbol)));
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
                let rest = residual(modes, compiled, &layout, &fidelity);
                assert!(rest.iter().all(Zero::is_zero), "M = {modes}, {layout}, {fidelity}: {rest:?}");
            }
        }
    }
}
