//! What an import took for granted or found odd, for the user to read.

use std::fmt;
use std::path::{Path, PathBuf};

use ffrf_model::printable;

use super::error::shown;

/// A remark on files that were accepted. `Display` prints it with its weight in front, control characters escaped.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// How much it matters.
    pub weight: Weight,
    /// The file that it is about, if it is about one.
    pub path: Option<PathBuf>,
    /// One sentence.
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
        Note { weight: Weight::Reading, path: None, text: text.into() }
    }

    pub(crate) fn warning(text: impl Into<String>) -> Self {
        Note { weight: Weight::Warning, path: None, text: text.into() }
    }

    /// The same note about a file.
    pub(crate) fn about(self, path: &Path) -> Self {
        Note { path: Some(path.to_path_buf()), ..self }
    }

    /// The note for the provenance of a body: the file without its folder, so that the same data gives the same body
    /// everywhere.
    pub(crate) fn for_provenance(&self) -> String {
        let name = self.path.as_deref().map(file_name);
        self.named(name.as_deref())
    }

    fn named(&self, file: Option<&str>) -> String {
        let text = printable(&self.text);
        match file {
            Some(file) => format!("{file}: {text}"),
            None => text,
        }
    }
}

/// The name of a file without its folder, as notes quote it.
pub(crate) fn file_name(path: &Path) -> String {
    printable(&path.file_name().unwrap_or_default().to_string_lossy())
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let weight = match self.weight {
            Weight::Reading => "note",
            Weight::Warning => "warning",
        };
        let file = self.path.as_deref().map(shown);
        write!(f, "{weight}: {}", self.named(file.as_deref()))
    }
}
