//! Expression trees as Rust, with the parentheses that they need.

use super::Style;
use super::literal::literal;
use super::parameters::place;
use crate::ScalarType;
use crate::emit::listing::{Operation, Tree};
use crate::expression::Symbol;

/// How tightly the outermost operation of a text binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
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
struct Text {
    /// Whether it begins with a minus, which is not in `text`.
    is_negative: bool,
    text: String,
    binding: Binding,
}

/// The text of a tree.
pub(super) fn expression(tree: &Tree, style: Style<'_>) -> String {
    Text::of(tree, style).whole()
}

impl Text {
    fn new(text: impl Into<String>, binding: Binding) -> Self {
        Self { is_negative: false, text: text.into(), binding }
    }

    fn whole(&self) -> String {
        let sign = if self.is_negative { "-" } else { "" };
        format!("{sign}{}", self.text)
    }

    /// The text as an operand that must bind at least as tightly as `least`.
    fn operand(&self, least: Binding) -> String {
        if self.binding >= least { self.whole() } else { format!("({})", self.whole()) }
    }

    /// The text as the first operand of a binary operation that asks for `least`: sign, rest.
    fn leading(&self, least: Binding) -> (bool, String) {
        if self.binding >= least {
            (self.is_negative, self.text.clone())
        } else {
            (false, self.operand(least))
        }
    }

    fn of(tree: &Tree, style: Style<'_>) -> Self {
        use Binding::{Atom, Sign};
        match tree {
            Tree::Number(value) => Self::number(*value, style.scalar),
            Tree::Symbol(symbol) => Self::symbol(*symbol, style),
            Tree::Name(name) => Self::new(name, Atom),
            Tree::Negate(a) => {
                Self { is_negative: true, ..Self::new(Self::of(a, style).operand(Atom), Sign) }
            }
            Tree::Binary(operation, operands) => {
                let [a, b] = operands.each_ref().map(|operand| Self::of(operand, style));
                Self::binary(*operation, &a, &b)
            }
            Tree::MultiplyAdd(operands) => {
                let [a, b, c] = operands.each_ref().map(|operand| Self::of(operand, style).whole());
                Self::new(format!("fma({a}, {b}, {c})"), Atom)
            }
            Tree::SquareRoot(a) => Self::new(format!("square_root({})", Self::of(a, style).whole()), Atom),
        }
    }

    fn binary(operation: Operation, a: &Self, b: &Self) -> Self {
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

    fn number(value: f64, scalar: ScalarType) -> Self {
        if scalar == ScalarType::Generic {
            return Self::new(format!("constant({})", literal(value, scalar)), Binding::Atom);
        }
        let is_negative = value < 0.0;
        let binding = if is_negative { Binding::Sign } else { Binding::Atom };
        Self { is_negative, ..Self::new(literal(value.abs(), scalar), binding) }
    }

    fn symbol(symbol: Symbol, style: Style<'_>) -> Self {
        let text = match (symbol, style.parameters) {
            (Symbol::Parameter(invariant, indices), Some(parameters)) => {
                let place = place(invariant, &indices, parameters.layout);
                if style.scalar == ScalarType::Generic { format!("constant({place})") } else { place }
            }
            _ => symbol.to_string(),
        };
        Self::new(text, Binding::Atom)
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
        let style = Style { scalar: ScalarType::F64, parameters: None };
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
            assert_eq!(expression(&binary(operation, left, right), style), expected);
        }
    }
}
