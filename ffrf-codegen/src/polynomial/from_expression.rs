//! The polynomial that an expression computes.

use std::collections::BTreeMap;

use super::{Polynomial, PolynomialError};
use crate::expression::{Expression, Graph, Node, Symbol};

/// The polynomial of each output, in the symbols of the graph.
///
/// Constants are taken exactly; a [`Node::MultiplyAdd`] is an exact product and sum. Division by a
/// constant power of two is exact, too.
///
/// Errors: a quotient or a square root is needed; a constant is not finite; a coefficient overflows.
pub fn polynomials_of(
    graph: &Graph,
    outputs: &[Expression],
) -> Result<Vec<Polynomial<Symbol>>, PolynomialError> {
    let needed = graph.reachable(outputs);
    let mut known: BTreeMap<Expression, Polynomial<Symbol>> = BTreeMap::new();
    let zero = Polynomial::zero();
    for (handle, node) in graph.nodes().take(needed.len()).filter(|(handle, _)| needed[handle.index()]) {
        // Operands stand before their node and are needed if it is: the fallback is never taken.
        let at = |expression: Expression| known.get(&expression).unwrap_or(&zero);
        let polynomial = match node {
            Node::Constant(constant) => Polynomial::constant(constant.value())?,
            Node::Symbol(symbol) => Polynomial::variable(symbol),
            Node::Negate(a) => at(a).negate(),
            Node::Add(a, b) => at(a).add(at(b))?,
            Node::Subtract(a, b) => at(a).subtract(at(b))?,
            Node::Multiply(a, b) => at(a).multiply(at(b))?,
            Node::MultiplyAdd(a, b, c) => at(a).multiply(at(b))?.add(at(c))?,
            Node::Divide(a, b) => at(a).multiply(&reciprocal(graph, b)?)?,
            Node::SquareRoot(_) => return Err(PolynomialError::SquareRoot),
        };
        known.insert(handle, polynomial);
    }
    Ok(outputs.iter().map(|output| known.get(output).unwrap_or(&zero).clone()).collect())
}

/// 1 / divisor, if it is a constant power of two, so that its reciprocal is exact.
fn reciprocal(graph: &Graph, divisor: Expression) -> Result<Polynomial<Symbol>, PolynomialError> {
    let value = graph.constant_value(divisor).ok_or(PolynomialError::Division)?;
    let fraction_bits = value.to_bits() & ((1 << 52) - 1);
    if fraction_bits == 0 && value.is_normal() && value.recip().is_normal() {
        Polynomial::constant(value.recip())
    } else {
        Err(PolynomialError::Division)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Input;

    #[test]
    fn factored_and_expanded_forms_are_one_polynomial() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let y = graph.symbol(Input::COORDINATES.symbol(1));
        let sum = graph.add(x, y);
        let difference = graph.subtract(x, y);
        let factored = graph.multiply(sum, difference);
        let x_squared = graph.multiply(x, x);
        let y_squared = graph.multiply(y, y);
        let expanded = graph.subtract(x_squared, y_squared);
        let minus_y = graph.negate(y);
        let fused = graph.multiply_add(minus_y, y, x_squared);
        let two = graph.constant(2.0);
        let doubled = graph.add(expanded, expanded);
        let halved = graph.divide(doubled, two);
        let results = polynomials_of(&graph, &[factored, expanded, fused, halved]).unwrap();
        assert_eq!(results[0].to_string(), "-q1^2 + q0^2");
        assert!(results.iter().all(|polynomial| *polynomial == results[0]));
    }

    #[test]
    fn what_is_not_a_polynomial_is_rejected() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let one = graph.one();
        let three = graph.constant(3.0);
        let quotient = graph.divide(one, x);
        let third = graph.divide(x, three);
        let root = graph.square_root(x);
        assert_eq!(polynomials_of(&graph, &[quotient]), Err(PolynomialError::Division));
        assert_eq!(polynomials_of(&graph, &[third]), Err(PolynomialError::Division));
        assert_eq!(polynomials_of(&graph, &[root]), Err(PolynomialError::SquareRoot));
    }
}
