//! A square matrix file of any kind, told apart by its first bytes.

use std::path::Path;

use super::{listed_matrix, matrix_market, numpy};
use crate::import::matrix::raw_matrix::RawMatrix;
use crate::import::matrix::sparse_lines::SparseLines;
use crate::import::nodes::NodeLookup;
use crate::import::text::source::Source;
use crate::{FeError, Nodes, SparseMatrix};

/// Reads one symmetric matrix as it stands, without the checks that [`read_model`](crate::import::read_model) makes on
/// definiteness, sizes and boundary conditions.
///
/// Shape: as the file declares; for lists the largest index; for lists with node labels 3N x 3N. Both triangles.
///
/// # Errors
/// A file that does not follow its format, or an asymmetric matrix.
pub fn read_matrix(path: &Path, nodes: &Nodes) -> Result<SparseMatrix, FeError> {
    let raw = read(path, &NodeLookup::new(&nodes.ids))?;
    SparseLines::from_entries(raw.entries, raw.size).symmetric(raw.storage, raw.source.path())
}

/// Reads Matrix Market, NumPy and headerless lists.
pub(crate) fn read(path: &Path, nodes: &NodeLookup) -> Result<RawMatrix, FeError> {
    let source = Source::read_unhashed(path)?;
    let bytes = source.bytes();
    if matrix_market::is_matrix_market(bytes) {
        matrix_market::read_square(source)
    } else if bytes.starts_with(numpy::NPY_MAGIC) || bytes.starts_with(numpy::NPZ_MAGIC) {
        numpy::read_square(source)
    } else {
        listed_matrix::read(source, nodes)
    }
}
