//! The table of matrix formats: how each is recognised by its first bytes, and its readers.

use std::path::Path;

use super::nastran::{dmig, op4};
use super::{listed_matrix, matrix_market, numpy, text_table};
use crate::import::matrix::raw_matrix::{Dense, MatrixRole, RawMatrix, ShapeCheck};
use crate::import::matrix::sparse_lines::SparseLines;
use crate::import::nodes::NodeLookup;
use crate::import::text::source::Source;
use crate::import::{INFLATED_LIMIT, ImportError};
use crate::{Nodes, SparseMatrix};

/// Rows up to which a matrix of few entries is accepted: an array of this length takes 128 MB.
const ROWS_OF_ANY_MATRIX: usize = 1 << 24;

/// One way to store a matrix in a file.
struct MatrixFormat {
    /// Whether a file that starts like this is one. The last format takes what the others leave.
    recognises: fn(&[u8]) -> bool,
    /// Reads a square matrix as listed entries; of several, that of the role.
    square: fn(Source, &NodeLookup, MatrixRole) -> Result<RawMatrix, ImportError>,
    /// Reads a matrix of any shape into columns.
    dense: fn(&Source, &ShapeCheck<'_>) -> Result<Dense, ImportError>,
}

static FORMATS: [MatrixFormat; 5] = [
    MatrixFormat {
        recognises: matrix_market::is_matrix_market,
        square: |source, _, _| matrix_market::read_square(source),
        dense: matrix_market::read_dense,
    },
    MatrixFormat {
        recognises: numpy::is_numpy,
        square: |source, _, _| numpy::read_square(source),
        dense: |source, check| numpy::read_dense(source, &["Psi", "psi", "modes", "K_ff"], check),
    },
    MatrixFormat { recognises: op4::is_op4, square: op4::read, dense: op4::refuse_dense },
    MatrixFormat { recognises: dmig::is_dmig, square: dmig::read, dense: dmig::refuse_dense },
    MatrixFormat {
        recognises: |_| true,
        square: |source, nodes, _| listed_matrix::read(source, nodes),
        dense: text_table::read_dense,
    },
];

fn format_of(source: &Source) -> &'static MatrixFormat {
    let [first, second, third, fourth, rest] = &FORMATS;
    [first, second, third, fourth]
        .into_iter()
        .find(|format| (format.recognises)(source.bytes()))
        .unwrap_or(rest)
}

/// Reads a square matrix of any format.
pub(crate) fn read_square(
    source: Source,
    nodes: &NodeLookup,
    role: MatrixRole,
) -> Result<RawMatrix, ImportError> {
    (format_of(&source).square)(source, nodes, role)
}

/// Reads a dense matrix of any format. `check` sees the shape before anything of its size is allocated.
pub(super) fn read_dense(source: &Source, check: &ShapeCheck<'_>) -> Result<Dense, ImportError> {
    let dense = (format_of(source).dense)(source, check)?;
    check(dense.rows, dense.columns)?;
    Ok(dense)
}

/// Reads one symmetric matrix as it stands, without the checks that [`read_model`](crate::import::read_model) makes on
/// definiteness, sizes and boundary conditions.
///
/// Shape: as the file declares; for lists the largest index; for lists with node labels 3N x 3N. Both triangles.
///
/// # Errors
/// A file that does not follow its format, an asymmetric matrix, or far more rows than entries.
pub fn read_matrix(path: &Path, nodes: &Nodes) -> Result<SparseMatrix, ImportError> {
    let source = Source::read_unhashed(path, INFLATED_LIMIT)?;
    let raw = read_square(source, &NodeLookup::new(&nodes.ids), MatrixRole::Unknown)?;
    let most = ROWS_OF_ANY_MATRIX.max(64 * raw.entries.len());
    if raw.size > most {
        return Err(ImportError::SizeMismatch {
            path: path.to_path_buf(),
            expected: format!("at most {most} rows for {} entries", raw.entries.len()),
            found: raw.size,
            what: "rows",
        });
    }
    SparseLines::from_entries(raw.entries, raw.size).symmetric(raw.storage, raw.source.path())
}
