//! Expressions as C.

use std::collections::BTreeSet;

use super::Style;
use crate::ScalarType;
use crate::emit::expression::{self, Binding, Text};
use crate::emit::listing::Operation;
use crate::emit::literal::literal;
use crate::expression::Symbol;

/// How one function writes its expressions.
pub(super) struct Notation<'a> {
    scalar: ScalarType,
    /// Names that temporaries cannot have: those of arguments.
    taken: Option<&'a BTreeSet<&'a str>>,
}

impl<'a> Notation<'a> {
    /// The notation of a function whose arguments have the names `taken`.
    pub(super) fn new(style: &Style, taken: Option<&'a BTreeSet<&'a str>>) -> Self {
        Self { scalar: style.scalar, taken }
    }
}

/// A number with the suffix of its type.
pub(super) fn number(value: f64, scalar: ScalarType) -> String {
    let suffix = if scalar == ScalarType::F32 { "f" } else { "" };
    format!("{}{suffix}", literal(value, scalar))
}

/// The scalar type.
pub(super) fn type_name(scalar: ScalarType) -> &'static str {
    if scalar == ScalarType::F32 { "float" } else { "double" }
}

/// The function of the library.
pub(super) fn square_root_name(scalar: ScalarType) -> &'static str {
    if scalar == ScalarType::F32 { "sqrtf" } else { "sqrt" }
}

impl expression::Notation for Notation<'_> {
    fn number(&self, value: f64) -> Text {
        Text::number(value < 0.0, number(value.abs(), self.scalar))
    }

    fn symbol(&self, symbol: Symbol) -> String {
        self.name(&symbol.to_string())
    }

    /// An underscore tells a temporary from an argument or a word of the language.
    fn name(&self, name: &str) -> String {
        if KEYWORDS.contains(&name) || self.taken.is_some_and(|taken| taken.contains(name)) {
            format!("{name}_")
        } else {
            name.to_owned()
        }
    }

    /// The compiler may contract it, as the options of the compiler say.
    fn multiply_add(&self, operands: [Text; 3]) -> Text {
        let [a, b, c] = operands;
        let product = Text::binary(Operation::Multiply, &a, &b);
        Text::new(Text::binary(Operation::Add, &product, &c).in_parentheses(), Binding::Atom)
    }

    fn square_root(&self, operand: &str) -> String {
        format!("{}({operand})", square_root_name(self.scalar))
    }
}

/// Words of C and C++ that a formulation could use as a name.
const KEYWORDS: [&str; 19] = [
    "auto", "break", "case", "char", "const", "default", "do", "double", "else", "extern", "float", "for",
    "if", "int", "long", "new", "register", "short", "static",
];
