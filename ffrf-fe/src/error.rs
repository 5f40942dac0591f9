//! The error type of this crate.

use std::path::PathBuf;

/// What can go wrong between a finite-element export and a reduced body.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FeError {
    /// A file cannot be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// A line of a file is not what its format asks for.
    #[error("{}:{line}: expected {expected}, found {found}", path.display())]
    Parse {
        /// The file.
        path: PathBuf,
        /// Line number from 1.
        line: usize,
        /// What should stand there.
        expected: String,
        /// What stands there.
        found: String,
    },
}
