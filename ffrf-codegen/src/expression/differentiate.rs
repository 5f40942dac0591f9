//! Symbolic differentiation.

use super::{Expression, Graph, Node, Symbol};

/// ∂ output / ∂ symbol for each output, as new nodes of the same graph.
pub fn differentiate(graph: &mut Graph, outputs: &[Expression], symbol: Symbol) -> Vec<Expression> {
    let needed = graph.reachable(outputs);
    let zero = graph.zero();
    let mut derivatives = vec![zero; needed.len()];
    for index in (0..needed.len()).filter(|&index| needed[index]) {
        let handle = Expression(index as u32);
        let d = |expression: Expression| derivatives[expression.index()];
        derivatives[index] = match graph.node(handle) {
            Node::Constant(_) => zero,
            Node::Symbol(other) => {
                if other == symbol {
                    graph.one()
                } else {
                    zero
                }
            }
            Node::Negate(a) => graph.negate(d(a)),
            Node::Add(a, b) => graph.add(d(a), d(b)),
            Node::Subtract(a, b) => graph.subtract(d(a), d(b)),
            Node::Multiply(a, b) => {
                let left = graph.multiply(d(a), b);
                let right = graph.multiply(a, d(b));
                graph.add(left, right)
            }
            Node::MultiplyAdd(a, b, c) => {
                let left = graph.multiply(d(a), b);
                let right = graph.multiply(a, d(b));
                let product = graph.add(left, right);
                graph.add(product, d(c))
            }
            Node::Divide(a, b) => {
                // (a / b)' = (a' - (a / b) b') / b
                let correction = graph.multiply(handle, d(b));
                let numerator = graph.subtract(d(a), correction);
                graph.divide(numerator, b)
            }
            Node::SquareRoot(a) => {
                let half = graph.scale(0.5, d(a));
                graph.divide(half, handle)
            }
        };
    }
    outputs.iter().map(|output| derivatives[output.index()]).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{Input, evaluate};
    use super::*;
    use crate::invariants::Invariant;

    #[test]
    fn derivatives_agree_with_central_differences() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let y = graph.symbol(Input::COORDINATES.symbol(1));
        let product = graph.multiply(x, y);
        let quotient = graph.divide(product, y);
        let shifted = graph.insert(Node::MultiplyAdd(quotient, x, y));
        let difference = graph.subtract(shifted, product);
        let ratio = graph.divide(difference, y);
        let root = graph.square_root(shifted);
        let minus = graph.negate(root);
        let outputs = [difference, ratio, minus];
        let derivatives = differentiate(&mut graph, &outputs, Input::COORDINATES.symbol(0));
        let at = |expressions: &[Expression], x: f64| {
            evaluate(&graph, expressions, |symbol| match symbol {
                Symbol::Input(Input::COORDINATES, 0) => x,
                _ => 1.7,
            })
        };
        let step = 1e-5;
        let exact = at(&derivatives, 0.8);
        let (up, down) = (at(&outputs, 0.8 + step), at(&outputs, 0.8 - step));
        for k in 0..outputs.len() {
            let central = (up[k] - down[k]) / (2.0 * step);
            // Central differences: error of order step^2.
            assert!((exact[k] - central).abs() < 1e-8, "output {k}: {} and {central}", exact[k]);
        }
    }

    #[test]
    fn derivative_with_respect_to_an_absent_symbol_is_the_constant_zero() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let square = graph.multiply(x, x);
        let derivative = differentiate(&mut graph, &[square], Invariant::Mass.at([]));
        assert!(graph.is_zero(derivative[0]));
    }
}
