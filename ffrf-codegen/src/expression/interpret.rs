//! The interpreter: the naive witness for everything that the emitter prints.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Expression, Graph, Node, Symbol};

/// What the interpreter computes with.
pub trait Scalar:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The nearest value to a constant.
    fn from_constant(value: f64) -> Self;
    /// √self
    fn square_root(self) -> Self;
}

impl Scalar for f64 {
    fn from_constant(value: f64) -> Self {
        value
    }
    fn square_root(self) -> Self {
        self.sqrt()
    }
}

impl Scalar for f32 {
    fn from_constant(value: f64) -> Self {
        value as Self
    }
    fn square_root(self) -> Self {
        self.sqrt()
    }
}

/// Values of `outputs`, with the inputs given by `value_of`.
///
/// Nodes that no output needs are not computed. A [`Node::MultiplyAdd`] is computed with two roundings.
pub fn evaluate<T: Scalar>(
    graph: &Graph,
    outputs: &[Expression],
    mut value_of: impl FnMut(Symbol) -> T,
) -> Vec<T> {
    let needed = graph.reachable(outputs);
    let zero = T::from_constant(0.0);
    let mut values: Vec<T> = Vec::with_capacity(needed.len());
    for (handle, node) in graph.nodes().take(needed.len()) {
        if !needed[handle.index()] {
            values.push(zero.clone());
            continue;
        }
        let at = |expression: Expression| values[expression.index()].clone();
        let value = match node {
            Node::Constant(constant) => T::from_constant(constant.value()),
            Node::Symbol(symbol) => value_of(symbol),
            Node::Negate(a) => -at(a),
            Node::Add(a, b) => at(a) + at(b),
            Node::Subtract(a, b) => at(a) - at(b),
            Node::Multiply(a, b) => at(a) * at(b),
            Node::MultiplyAdd(a, b, c) => at(a) * at(b) + at(c),
            Node::Divide(a, b) => at(a) / at(b),
            Node::SquareRoot(a) => at(a).square_root(),
        };
        values.push(value);
    }
    outputs.iter().map(|output| values[output.index()].clone()).collect()
}

impl Graph {
    /// For each node up to the last that `outputs` need: whether they need it.
    pub fn reachable(&self, outputs: &[Expression]) -> Vec<bool> {
        let length = outputs.iter().map(|output| output.index() + 1).max().unwrap_or(0);
        let mut needed = vec![false; length];
        for output in outputs {
            needed[output.index()] = true;
        }
        for index in (0..length).rev() {
            if needed[index] {
                for operand in self.node(Expression(index as u32)).operands() {
                    needed[operand.index()] = true;
                }
            }
        }
        needed
    }
}

#[cfg(test)]
mod tests {
    use super::super::Input;
    use super::*;
    use crate::invariants::Invariant;

    #[test]
    fn every_operation_has_its_value() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let y = graph.symbol(Input::COORDINATES.symbol(1));
        let outputs = [
            graph.negate(x),
            graph.add(x, y),
            graph.subtract(x, y),
            graph.multiply(x, y),
            graph.insert(Node::MultiplyAdd(x, y, y)),
            graph.divide(x, y),
            graph.square_root(y),
        ];
        let values = evaluate(&graph, &outputs, |symbol| match symbol {
            Symbol::Input(Input::COORDINATES, 0) => 3.0,
            _ => 4.0,
        });
        assert_eq!(values, [-3.0, 7.0, -1.0, 12.0, 16.0, 0.75, 2.0]);
        let single = evaluate(&graph, &outputs, |_| 4.0_f32);
        assert_eq!(single, [-4.0, 8.0, 0.0, 16.0, 20.0, 1.0, 2.0]);
    }

    #[test]
    fn what_no_output_needs_is_not_asked_for() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        graph.symbol(Invariant::Mass.at([]));
        let y = graph.symbol(Input::COORDINATES.symbol(1));
        let sum = graph.add(x, y);
        let values = evaluate(&graph, &[sum], |symbol| {
            assert_ne!(symbol, Invariant::Mass.at([]));
            1.0
        });
        assert_eq!(values, [2.0]);
    }
}
