//! What an import took for granted or found odd, for the user to read.

use std::fmt;

/// A remark on files that were accepted. `Display` prints it with its weight in front.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// How much it matters.
    pub weight: Weight,
    /// One sentence, naming the file.
    pub text: String,
}

/// How much a [`Note`] matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weight {
    /// How a file was read where it does not say so itself.
    Reading,
    /// Numbers that solids do not have, or that contradict each other.
    Warning,
}

impl Note {
    pub(crate) fn reading(text: impl Into<String>) -> Self {
        Note { weight: Weight::Reading, text: text.into() }
    }

    pub(crate) fn warning(text: impl Into<String>) -> Self {
        Note { weight: Weight::Warning, text: text.into() }
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let weight = match self.weight {
            Weight::Reading => "note",
            Weight::Warning => "warning",
        };
        write!(f, "{weight}: {}", self.text)
    }
}
