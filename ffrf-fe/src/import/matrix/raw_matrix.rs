//! A matrix as a file states it, before symmetry, sizes and boundary conditions are settled.

use super::entries::Entries;
use crate::FeError;
use crate::import::text::source::Source;

/// Entries of one file with what is known of their meaning.
#[derive(Debug)]
pub(crate) struct RawMatrix {
    /// The file.
    pub(crate) source: Source,
    /// The entries.
    pub(crate) entries: Entries,
    /// Number of rows = columns: declared by a header, or the largest index of a list.
    pub(crate) size: usize,
    /// Which triangles the entries cover.
    pub(crate) storage: Storage,
    /// What the indices count.
    pub(crate) numbering: Numbering,
}

/// Which triangles of a symmetric matrix a file stores.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Storage {
    /// Both, by declaration.
    Full,
    /// One, by declaration.
    OneTriangle,
    /// Not declared: one if no entry has its mirror image in the file.
    Undeclared,
}

/// What the indices of a raw matrix count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Numbering {
    /// Rows of a complete matrix: a header declares the size.
    Declared,
    /// Rows of a list without header: a row that never occurs is a degree of freedom that was left out.
    Listed,
    /// Degrees of freedom 3 n + i of the node table, found through labels.
    Labelled,
}

/// A small dense matrix as read, column by column.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Dense {
    /// Number of rows.
    pub(crate) rows: usize,
    /// Number of columns.
    pub(crate) columns: usize,
    /// Values column by column.
    pub(crate) values: Vec<f64>,
}

impl RawMatrix {
    /// Checks a declared shape.
    pub(crate) fn square(source: &Source, rows: usize, columns: usize) -> Result<usize, FeError> {
        if rows != columns {
            return Err(FeError::NotSquare { path: source.path().to_path_buf(), rows, columns });
        }
        Ok(rows)
    }
}
