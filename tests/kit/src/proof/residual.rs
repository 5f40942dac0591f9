//! Accelerations put back into the derived equations of motion, in rational arithmetic.

use ffrf_codegen::derive::EulerPoincare;
use ffrf_codegen::expression::{Expression, Graph, Input, Symbol, evaluate};
use num_rational::BigRational;
use num_traits::Zero;

use crate::proof::exact::Exact;
use crate::proof::sample::value;

/// M w + Q + [0; 0; internal] - force with the derived M and Q.
///
/// In rational arithmetic: an identity of rational functions that holds at random points without any
/// rounding holds everywhere, but for a chance that no one lives to see (Schwartz-Zippel).
pub fn residual(
    graph: &Graph,
    derived: &EulerPoincare,
    internal: &[Expression],
    acceleration: &[Expression],
    seed: u64,
) -> Vec<BigRational> {
    let exact = |symbol: Symbol| BigRational::from_float(value(symbol, seed)).unwrap();
    let size = acceleration.len();
    let mut outputs = acceleration.to_vec();
    outputs.extend(&derived.quadratic_velocity);
    outputs.extend(derived.mass_matrix.concat());
    outputs.extend(internal);
    let results = evaluate(graph, &outputs, |symbol| Exact(exact(symbol)));
    let number = |index: usize| results[index].0.clone();
    assert!((0..size).any(|row| !number(row).is_zero()), "at rest: nothing is tested");
    (0..size)
        .map(|row| {
            let inertial = (0..size)
                .map(|column| number(2 * size + row * size + column) * number(column))
                .fold(BigRational::zero(), |sum, product| sum + product);
            let elastic =
                if row < 6 { BigRational::zero() } else { number(2 * size + size * size + row - 6) };
            inertial + number(size + row) + elastic - exact(Input::FORCE.symbol(row))
        })
        .collect()
}
