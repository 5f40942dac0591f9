//! What a computation takes for granted.

use crate::expression::Expression;

/// A relation of two numbers. Of numbers that are none, only [`NotEqual`](Self::NotEqual) holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Relation {
    /// a < b
    Less,
    /// a <= b
    LessOrEqual,
    /// a = b
    Equal,
    /// a is not b
    NotEqual,
    /// a > b
    Greater,
    /// a >= b
    GreaterOrEqual,
    /// a is finite, whatever b is.
    Finite,
}

impl Relation {
    /// Whether it holds.
    pub fn holds(self, left: f64, right: f64) -> bool {
        match self {
            Self::Less => left < right,
            Self::LessOrEqual => left <= right,
            Self::Equal => left == right,
            Self::NotEqual => left != right,
            Self::Greater => left > right,
            Self::GreaterOrEqual => left >= right,
            Self::Finite => left.is_finite(),
        }
    }
}

/// A relation of two expressions of one graph that is taken for granted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Condition {
    /// What stands on its left.
    pub left: Expression,
    /// What stands on its right.
    pub right: Expression,
    /// What is between them.
    pub relation: Relation,
}
