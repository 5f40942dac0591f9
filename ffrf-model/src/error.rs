//! The error type of this crate.

use std::path::{Path, PathBuf};

use crate::measured::Check;
use crate::text::printable;

/// What can be wrong with a reduced body or with its file.
///
/// What a message quotes of a file is [`printable`].
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ModelError {
    /// The file cannot be read or written.
    #[error("{}: {source}", shown(path))]
    Io {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// The content of a file is at fault.
    #[error("{}: {source}", shown(path))]
    File {
        /// The file.
        path: PathBuf,
        /// The fault, with the field it is in.
        source: Box<ModelError>,
    },
    /// The text is not JSON, e.g. `{"title": }`.
    #[error("line {line}, column {column}: {}", printable(message))]
    Syntax {
        /// Line number from 1.
        line: usize,
        /// Column number from 1.
        column: usize,
        /// What the JSON reader expected.
        message: String,
    },
    /// A version of the file format that this library does not know, e.g. `{"schema_version": 99}`.
    #[error("schema_version: found {found}, this version of ffrf reads {known}")]
    Version {
        /// The version in the file.
        found: u64,
        /// The version that this library reads.
        known: u32,
    },
    /// A field is missing, unknown, or of the wrong type, e.g. `"mass": "heavy"`.
    #[error("{}: {} (line {line}, column {column})", printable(field), printable(message))]
    Field {
        /// Full path of the field, e.g. `inertia.mode_mode_moment[3][1]`.
        field: String,
        /// What was expected and what was found.
        message: String,
        /// Line number from 1.
        line: usize,
        /// Column number from 1.
        column: usize,
    },
    /// A number is infinite or not a number.
    #[error("{field}: {found} is not a finite number")]
    NotFinite {
        /// Full path of the field.
        field: String,
        /// The number.
        found: f64,
    },
    /// A list has the wrong length.
    #[error("{field}: expected {expected} entries (one per mode), found {found}")]
    Length {
        /// Full path of the field.
        field: String,
        /// Number of modes M.
        expected: usize,
        /// Length of the list.
        found: usize,
    },
    /// More modes were asked for than the body has.
    #[error("{requested} modes asked for, but the body has {available}")]
    TooFewModes {
        /// Number of modes asked for.
        requested: usize,
        /// Number of modes M.
        available: usize,
    },
    /// A mode was asked for that the body does not have.
    #[error("mode {index} asked for, but the body has {available} modes, counted from 0")]
    NoSuchMode {
        /// Index of the mode, from 0.
        index: usize,
        /// Number of modes M.
        available: usize,
    },
    /// A mode was asked for twice.
    #[error("mode {index} asked for twice")]
    RepeatedMode {
        /// Index of the mode, from 0.
        index: usize,
    },
    /// The numbers contradict each other or physics.
    #[error("the body is not consistent: {}", list(failures))]
    Inconsistent {
        /// The checks that failed, with their measured numbers and limits.
        failures: Vec<Check>,
    },
}

fn shown(path: &Path) -> String {
    printable(&path.to_string_lossy())
}

fn list(failures: &[Check]) -> String {
    failures.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}
