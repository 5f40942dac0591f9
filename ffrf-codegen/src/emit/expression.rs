//! Expression trees in infix notation, with the parentheses that they need.

use super::listing::{Operation, Tree};
use crate::expression::Symbol;

/// What languages write differently; operators, their order and parentheses are the same in all.
pub(super) trait Notation {
    /// A number.
    fn number(&self, value: f64) -> Text;
    /// An entry of an input or of an invariant.
    fn symbol(&self, symbol: Symbol) -> String;
    /// a b + c
    fn multiply_add(&self, operands: [Text; 3]) -> Text;
    /// √a
    fn square_root(&self, operand: &str) -> String;
    /// A temporary.
    fn name(&self, name: &str) -> String {
        name.to_owned()
    }
}

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
    /// Whether it begins with a minus, which is not in `text`.
    is_negative: bool,
    text: String,
    binding: Binding,
}

/// The text of a tree.
pub(super) fn expression(tree: &Tree, notation: &impl Notation) -> String {
    Text::of(tree, notation).whole()
}

impl Text {
    /// Text without a sign.
    pub(super) fn new(text: impl Into<String>, binding: Binding) -> Self {
        Self { is_negative: false, text: text.into(), binding }
    }

    /// A number, by the text of its absolute value.
    pub(super) fn number(is_negative: bool, magnitude: String) -> Self {
        let binding = if is_negative { Binding::Sign } else { Binding::Atom };
        Self { is_negative, ..Self::new(magnitude, binding) }
    }

    /// The text with its sign.
    pub(super) fn whole(&self) -> String {
        let sign = if self.is_negative { "-" } else { "" };
        format!("{sign}{}", self.text)
    }

    /// The text with its sign, in parentheses.
    pub(super) fn in_parentheses(&self) -> String {
        format!("({})", self.whole())
    }

    /// The text as an operand that must bind at least as tightly as `least`.
    fn operand(&self, least: Binding) -> String {
        if self.binding >= least { self.whole() } else { self.in_parentheses() }
    }

    /// The text as the first operand of a binary operation that asks for `least`: sign, rest.
    fn leading(&self, least: Binding) -> (bool, String) {
        if self.binding >= least {
            (self.is_negative, self.text.clone())
        } else {
            (false, self.operand(least))
        }
    }

    fn of(tree: &Tree, notation: &impl Notation) -> Self {
        use Binding::{Atom, Sign};
        match tree {
            Tree::Number(value) => notation.number(*value),
            Tree::Symbol(symbol) => Self::new(notation.symbol(*symbol), Atom),
            Tree::Name(name) => Self::new(notation.name(name), Atom),
            Tree::Negate(a) => {
                Self { is_negative: true, ..Self::new(Self::of(a, notation).operand(Atom), Sign) }
            }
            Tree::Binary(operation, operands) => {
                let [a, b] = operands.each_ref().map(|operand| Self::of(operand, notation));
                Self::binary(*operation, &a, &b)
            }
            Tree::MultiplyAdd(operands) => {
                notation.multiply_add(operands.each_ref().map(|operand| Self::of(operand, notation)))
            }
            Tree::SquareRoot(a) => Self::new(notation.square_root(&Self::of(a, notation).whole()), Atom),
        }
    }

    /// `a` and `b` with an operation between them.
    pub(super) fn binary(operation: Operation, a: &Self, b: &Self) -> Self {
        use Binding::{Product, Sign, Sum};
        let (sign, right, binding) = match operation {
            // a + -b and a - -b are written without the second sign.
            Operation::Add if b.is_negative && b.binding >= Product => ("-", b.text.clone(), Sum),
            Operation::Add => ("+", b.operand(Product), Sum),
            Operation::Subtract if b.is_negative && b.binding == Sign => ("+", b.text.clone(), Sum),
            Operation::Subtract => ("-", b.operand(Product), Sum),
            Operation::Multiply => ("*", b.operand(Sign), Product),
            Operation::Divide => ("/", b.operand(Sign), Product),
        };
        let (is_negative, left) = a.leading(binding);
        Self { is_negative, ..Self::new(format!("{left} {sign} {right}"), binding) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parentheses_stand_where_they_are_needed_and_nowhere_else() {
        let name = |name: &str| Tree::Name(name.to_owned());
        let binary =
            |operation, a: &Tree, b: &Tree| Tree::Binary(operation, Box::new([a.clone(), b.clone()]));
        let (a, b) = (name("a"), name("b"));
        let sum = binary(Operation::Add, &a, &b);
        let product = binary(Operation::Multiply, &a, &b);
        let minus = Tree::Negate(Box::new(product.clone()));
        let number = Tree::Number(-1.5);
        let scaled = binary(Operation::Multiply, &number, &a);
        struct Plain;
        impl Notation for Plain {
            fn number(&self, value: f64) -> Text {
                Text::number(value < 0.0, format!("{:?}", value.abs()))
            }

            fn symbol(&self, symbol: Symbol) -> String {
                symbol.to_string()
            }

            fn multiply_add(&self, operands: [Text; 3]) -> Text {
                Text::new(
                    format!("fma({})", operands.map(|operand| operand.whole()).join(", ")),
                    Binding::Atom,
                )
            }

            fn square_root(&self, operand: &str) -> String {
                format!("root({operand})")
            }
        }
        for (operation, left, right, expected) in [
            (Operation::Multiply, &sum, &a, "(a + b) * a"),
            (Operation::Subtract, &a, &sum, "a - (a + b)"),
            (Operation::Subtract, &sum, &a, "a + b - a"),
            (Operation::Add, &sum, &sum, "a + b + (a + b)"),
            (Operation::Add, &product, &product, "a * b + a * b"),
            (Operation::Multiply, &a, &product, "a * (a * b)"),
            (Operation::Add, &a, &number, "a - 1.5"),
            (Operation::Subtract, &a, &number, "a + 1.5"),
            (Operation::Multiply, &number, &a, "-1.5 * a"),
            (Operation::Multiply, &a, &number, "a * -1.5"),
            (Operation::Add, &a, &minus, "a - (a * b)"),
            (Operation::Add, &a, &scaled, "a - 1.5 * a"),
            (Operation::Subtract, &a, &scaled, "a - -1.5 * a"),
            (Operation::Add, &number, &a, "-1.5 + a"),
        ] {
            assert_eq!(expression(&binary(operation, left, right), &Plain), expected);
        }
    }
}
