//! What is wrong with an invariant, and where.

use core::fmt;

/// An invariant that no body can have: the field, the entry, the number found and what was expected.
///
/// `check` of a body whose invariants come at run time gives the first in the order of its documentation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InvariantError {
    /// Name of the field, or `mass_matrix` if the fields contradict each other.
    pub field: &'static str,
    /// Indices of the entry, or of the 3 x 3 matrix that the number was computed from.
    pub index: InvariantIndex,
    /// The number found.
    pub found: f64,
    /// What was expected.
    pub expected: InvariantExpectation,
}

/// What was expected of a number.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum InvariantExpectation {
    /// Neither an infinity nor not a number.
    Finite,
    /// Above zero.
    Positive,
    /// Zero or above.
    NotNegative,
    /// A value that follows from other entries or from the layout.
    Value {
        /// The value.
        value: f64,
        /// The largest difference that is accepted.
        within: f64,
        /// What the number is, and why it has this value.
        reason: &'static str,
    },
    /// A pivot of a positive definite matrix, over the entry on the diagonal before elimination.
    Pivot {
        /// The pivot is above this share of the entry.
        above: f64,
        /// Which matrix, and what it means if it is not positive definite.
        reason: &'static str,
    },
}

/// The indices of an entry: `[μ][ν][i][j]` in the largest field, none for the mass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct InvariantIndex {
    entries: [usize; 4],
    depth: usize,
}

impl InvariantIndex {
    /// No index: the field as a whole, or a number.
    pub(super) const EMPTY: Self = Self { entries: [0; 4], depth: 0 };

    /// The indices, outermost first.
    pub fn as_slice(&self) -> &[usize] {
        self.entries.get(..self.depth).unwrap_or(&[])
    }

    /// With one more index at the end; a fifth is left out.
    pub(super) fn then(mut self, index: usize) -> Self {
        if let Some(entry) = self.entries.get_mut(self.depth) {
            *entry = index;
            self.depth += 1;
        }
        self
    }
}

impl fmt::Display for InvariantIndex {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_slice().iter().try_for_each(|index| write!(formatter, "[{index}]"))
    }
}

impl fmt::Display for InvariantError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { field, index, found, expected } = self;
        write!(formatter, "{field}{index}: found {found:?}, expected {expected}")
    }
}

impl fmt::Display for InvariantExpectation {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Finite => formatter.write_str("a finite number"),
            Self::Positive => formatter.write_str("a positive number"),
            Self::NotNegative => formatter.write_str("a number that is not negative"),
            Self::Value { value, within, reason } => {
                write!(formatter, "{value:?} within {within:.1e} ({reason})")
            }
            Self::Pivot { above, reason } => write!(formatter, "a pivot above {above:.1e} ({reason})"),
        }
    }
}

impl core::error::Error for InvariantError {}
