//! Expressions as text, with the parentheses that they need.

use super::literal::literal;
use crate::ScalarType;
use crate::expression::Node;

/// How tightly the outermost operation of a text binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    /// a + b, a - b
    Sum,
    /// a * b, a / b
    Product,
    /// -a
    Sign,
    /// A name, a number, a call.
    Atom,
}

/// The text of an expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Text {
    pub(super) text: String,
    pub(super) binding: Binding,
}

impl Text {
    pub(super) fn atom(text: impl Into<String>) -> Self {
        Self { text: text.into(), binding: Binding::Atom }
    }

    pub(super) fn number(value: f64, scalar: ScalarType) -> Self {
        if scalar == ScalarType::Generic {
            return Self::atom(format!("constant({})", literal(value, scalar)));
        }
        let binding = if value < 0.0 { Binding::Sign } else { Binding::Atom };
        Self { text: literal(value, scalar), binding }
    }

    /// The text as an operand that must bind at least as tightly as `least`.
    fn operand(&self, least: Binding) -> String {
        if self.binding >= least { self.text.clone() } else { format!("({})", self.text) }
    }

    /// The text of an operation on operands that are printed already.
    pub(super) fn of(node: Node, operands: &[Self], scalar: ScalarType) -> Self {
        use Binding::{Atom, Product, Sign, Sum};
        let (text, binding) = match (node, operands) {
            (Node::Constant(constant), _) => return Self::number(constant.value(), scalar),
            (Node::Negate(_), [a]) => (format!("-{}", a.operand(Atom)), Sign),
            (Node::Add(..), [a, b]) => match b.text.strip_prefix('-') {
                Some(rest) if b.binding >= Product => (format!("{} - {rest}", a.operand(Sum)), Sum),
                _ => (format!("{} + {}", a.operand(Sum), b.operand(Product)), Sum),
            },
            (Node::Subtract(..), [a, b]) => match b.text.strip_prefix('-') {
                Some(rest) if b.binding == Sign => (format!("{} + {rest}", a.operand(Sum)), Sum),
                _ => (format!("{} - {}", a.operand(Sum), b.operand(Product)), Sum),
            },
            (Node::Multiply(..), [a, b]) => {
                (format!("{} * {}", a.operand(Product), b.operand(Sign)), Product)
            }
            (Node::Divide(..), [a, b]) => (format!("{} / {}", a.operand(Product), b.operand(Sign)), Product),
            (Node::MultiplyAdd(..), [a, b, c]) => (format!("fma({}, {}, {})", a.text, b.text, c.text), Atom),
            (Node::SquareRoot(_), [a]) => (format!("square_root({})", a.text), Atom),
            // A validated kernel has as many operands as its nodes need.
            _ => (String::new(), Atom),
        };
        Self { text, binding }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::{Graph, Symbol};

    #[test]
    fn parentheses_stand_where_they_are_needed_and_nowhere_else() {
        let mut graph = Graph::new();
        let handle = graph.symbol(Symbol::Mass);
        let print = |node, operands: &[Text]| Text::of(node, operands, ScalarType::F64);
        let (a, b) = (Text::atom("a"), Text::atom("b"));
        let add = Node::Add(handle, handle);
        let subtract = Node::Subtract(handle, handle);
        let multiply = Node::Multiply(handle, handle);
        let sum = print(add, &[a.clone(), b.clone()]);
        let product = print(multiply, &[a.clone(), b.clone()]);
        let minus = print(Node::Negate(handle), std::slice::from_ref(&product));
        let number = Text::number(-1.5, ScalarType::F64);
        for (node, operands, expected) in [
            (multiply, [&sum, &a], "(a + b) * a"),
            (subtract, [&a, &sum], "a - (a + b)"),
            (subtract, [&sum, &a], "a + b - a"),
            (add, [&sum, &sum], "a + b + (a + b)"),
            (add, [&product, &product], "a * b + a * b"),
            (multiply, [&a, &product], "a * (a * b)"),
            (add, [&a, &number], "a - 1.5"),
            (subtract, [&a, &number], "a + 1.5"),
            (multiply, [&number, &a], "-1.5 * a"),
            (multiply, [&a, &number], "a * -1.5"),
            (add, [&a, &minus], "a - (a * b)"),
        ] {
            assert_eq!(print(node, &[operands[0].clone(), operands[1].clone()]).text, expected);
        }
    }
}
