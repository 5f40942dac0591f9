//! A matrix as a file states it, before symmetry, sizes and boundary conditions are settled.

use super::entries::Entries;
use crate::import::text::source::Source;
use crate::import::{ImportError, Note};

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
    /// Degrees of freedom 3 n + i of the node table, found through labels in a list without header.
    Labelled,
    /// The same, where the format or another file says so.
    Named,
}

impl Numbering {
    /// Whether the indices are degrees of freedom of the node table, of which some may be missing.
    pub(crate) fn is_labelled(self) -> bool {
        matches!(self, Self::Labelled | Self::Named)
    }
}

/// What a matrix is for, for files that hold several.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MatrixRole {
    /// M.
    Mass,
    /// K.
    Stiffness,
    /// Not known.
    Unknown,
}

impl MatrixRole {
    /// The letter with which the names of such matrices start.
    pub(crate) fn initial(self) -> Option<char> {
        match self {
            Self::Mass => Some('M'),
            Self::Stiffness => Some('K'),
            Self::Unknown => None,
        }
    }
}

/// Judges a shape (rows, columns) before anything of its size is allocated.
pub(crate) type ShapeCheck<'a> = dyn Fn(usize, usize) -> Result<(), ImportError> + 'a;

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
    /// How a list without a header was read, which it does not say itself; `None` for other files, and for lists whose
    /// rows another file names.
    pub(crate) fn reading(&self) -> Option<Note> {
        let form = match self.numbering {
            Numbering::Listed => "`row column value`",
            Numbering::Labelled => "`node dof node dof value`",
            _ => return None,
        };
        let (size, entries) = (self.size, self.entries.len());
        let text = format!("a list without a header, read as {form} with {entries} entries of {size} rows");
        Some(Note::reading(text).about(self.source.path()))
    }

    /// Checks a declared shape.
    pub(crate) fn square(source: &Source, rows: usize, columns: usize) -> Result<usize, ImportError> {
        if rows != columns {
            return Err(ImportError::NotSquare { path: source.path().to_path_buf(), rows, columns });
        }
        Ok(rows)
    }
}
