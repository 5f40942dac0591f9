//! Expressions in the place of symbols.

use super::{Expression, Graph, Node, Symbol};

/// The outputs with `replacement(symbol)`, where there is one, in the place of each symbol; new nodes of the same graph.
///
/// Replacements are not searched for symbols again.
pub fn substitute(
    graph: &mut Graph,
    outputs: &[Expression],
    replacement: impl Fn(Symbol) -> Option<Expression>,
) -> Vec<Expression> {
    let needed = graph.reachable(outputs);
    let mut images: Vec<Expression> = Vec::with_capacity(needed.len());
    for index in 0..needed.len() {
        let handle = Expression(index as u32);
        if !needed[index] {
            images.push(handle);
            continue;
        }
        let at = |expression: Expression| images[expression.index()];
        let image = match graph.node(handle) {
            Node::Constant(_) => handle,
            Node::Symbol(symbol) => replacement(symbol).unwrap_or(handle),
            Node::Negate(a) => graph.negate(at(a)),
            Node::Add(a, b) => graph.add(at(a), at(b)),
            Node::Subtract(a, b) => graph.subtract(at(a), at(b)),
            Node::Multiply(a, b) => graph.multiply(at(a), at(b)),
            Node::MultiplyAdd(a, b, c) => graph.multiply_add(at(a), at(b), at(c)),
            Node::Divide(a, b) => graph.divide(at(a), at(b)),
            Node::SquareRoot(a) => graph.square_root(at(a)),
        };
        images.push(image);
    }
    outputs.iter().map(|output| images[output.index()]).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Input;
    use super::*;

    #[test]
    fn symbols_are_replaced_everywhere_and_the_result_folds() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let y = graph.symbol(Input::COORDINATES.symbol(1));
        let product = graph.multiply(x, y);
        let sum = graph.add(product, x);
        let minus_y = graph.negate(y);
        let zero = graph.zero();
        let replaced =
            |with| move |symbol| if symbol == Input::COORDINATES.symbol(0) { Some(with) } else { None };
        assert_eq!(substitute(&mut graph, &[sum], replaced(zero)), [zero]);
        let square = graph.multiply(y, y);
        let expected = graph.add(square, y);
        let expected = graph.negate(expected);
        assert_eq!(substitute(&mut graph, &[sum], replaced(minus_y)), [expected]);
        // symbols swap: replacements are not searched again
        let swapped = substitute(&mut graph, &[sum], |symbol| match symbol {
            Symbol::Input(Input::COORDINATES, 0) => Some(y),
            Symbol::Input(Input::COORDINATES, 1) => Some(x),
            _ => None,
        });
        assert_eq!(swapped, [graph.add(product, y)]);
    }
}
