//! One check of a body: a number and the limit it must keep.

use std::fmt;

use crate::text::printable;

/// One check: what was measured, and the limit it must keep.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// What was checked, in words.
    pub subject: String,
    /// The number that was found.
    pub measured: f64,
    /// What the number must satisfy.
    pub limit: Limit,
}

/// What a measured number must satisfy.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Limit {
    /// Not greater than this.
    AtMost(f64),
    /// Not less than this.
    AtLeast(f64),
    /// Greater than this.
    Above(f64),
}

impl Check {
    pub(crate) fn new(subject: impl Into<String>, measured: f64, limit: Limit) -> Self {
        Self { subject: subject.into(), measured, limit }
    }

    /// True if the number keeps its limit; a number that is not finite never does.
    pub fn passed(&self) -> bool {
        self.measured.is_finite()
            && match self.limit {
                Limit::AtMost(limit) => self.measured <= limit,
                Limit::AtLeast(limit) => self.measured >= limit,
                Limit::Above(limit) => self.measured > limit,
            }
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {:.3e}, must be {}", printable(&self.subject), self.measured, self.limit)
    }
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AtMost(limit) => write!(f, "at most {limit:.0e}"),
            Self::AtLeast(limit) => write!(f, "at least {limit:.0e}"),
            Self::Above(limit) => write!(f, "above {limit:.0e}"),
        }
    }
}
