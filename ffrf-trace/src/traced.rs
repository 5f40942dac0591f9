//! The number.

use std::fmt;

use ffrf_codegen::expression::{Expression, Symbol};

use crate::tape::{Call, Function, write};

/// A number with the expression that it is the value of, on the tape of this thread.
#[derive(Clone, Copy)]
pub struct Traced {
    pub(crate) node: Expression,
    pub(crate) value: f64,
}

impl Traced {
    /// An input. `value`: by which comparisons are decided.
    pub fn input(symbol: Symbol, value: f64) -> Self {
        Self { node: write(|tape| tape.graph.symbol(symbol)), value }
    }

    /// A number that is the same in every run.
    pub fn number(value: f64) -> Self {
        Self { node: write(|tape| tape.graph.constant(value)), value }
    }

    /// Its expression.
    pub fn expression(self) -> Expression {
        self.node
    }

    /// Its value in this run.
    pub fn value(self) -> f64 {
        self.value
    }

    /// Whether it is the same in every run.
    pub(crate) fn is_number(self) -> bool {
        write(|tape| tape.graph.constant_value(self.node).is_some())
    }

    /// A function that no node stands for.
    pub(crate) fn function(self, name: &'static str, of: impl FnOnce(f64) -> f64) -> Self {
        if self.is_number() { Self::number(of(self.value)) } else { Self::missing(name) }
    }

    /// A function whose value is an input of what follows.
    pub(crate) fn call(self, name: &'static str, function: Function) -> Self {
        let value = function.of(self.value);
        if self.is_number() {
            return Self::number(value);
        }
        match write(|tape| tape.call(Call { function, argument: self.node })) {
            Some(node) => Self { node, value },
            None => Self::missing(name),
        }
    }

    pub(crate) fn missing(name: &'static str) -> Self {
        write(|tape| tape.miss(name));
        Self::number(f64::NAN)
    }
}

impl fmt::Debug for Traced {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&self.value, f)
    }
}

impl fmt::Display for Traced {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.value, f)
    }
}
