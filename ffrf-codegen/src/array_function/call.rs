//! Functions that no node stands for, of what the inputs give directly.

use crate::expression::{Expression, Symbol};

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Function {
    /// sin
    Sine,
    /// cos
    Cosine,
}

impl Function {
    /// Its value.
    pub fn of(self, argument: f64) -> f64 {
        match self {
            Self::Sine => argument.sin(),
            Self::Cosine => argument.cos(),
        }
    }
}

/// A value of a function, which is an input of all that follows: angles of drives are turned into directions so.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Call {
    /// The function.
    pub function: Function,
    /// What it is of: an expression of inputs and of calls before it.
    pub argument: Expression,
}

impl Call {
    /// The symbol of the value of call `index`.
    pub fn symbol(index: usize) -> Symbol {
        Symbol::Intermediate(Self::ENTRY, index)
    }

    /// What the names of values begin with.
    pub(crate) const ENTRY: &str = "function";
}
