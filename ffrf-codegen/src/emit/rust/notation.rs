//! Expressions as Rust: numbers, symbols and the functions that operators do not write.

use super::Style;
use super::parameters::place;
use crate::ScalarType;
use crate::emit::expression::{Binding, Notation, Text};
use crate::emit::literal::literal;
use crate::expression::Symbol;

impl Notation for Style<'_> {
    fn number(&self, value: f64) -> Text {
        if self.scalar == ScalarType::Generic {
            return Text::new(format!("constant({})", literal(value, self.scalar)), Binding::Atom);
        }
        Text::number(value < 0.0, literal(value.abs(), self.scalar))
    }

    fn symbol(&self, symbol: Symbol) -> String {
        match (symbol, self.parameters) {
            (Symbol::Parameter(invariant, indices), Some(parameters)) => {
                let place = place(invariant, &indices, parameters.layout);
                if self.scalar == ScalarType::Generic { format!("constant({place})") } else { place }
            }
            _ => symbol.to_string(),
        }
    }

    fn multiply_add(&self, operands: [Text; 3]) -> Text {
        Text::new(format!("fma({})", operands.map(|operand| operand.whole()).join(", ")), Binding::Atom)
    }

    fn square_root(&self, operand: &str) -> String {
        format!("square_root({operand})")
    }
}
