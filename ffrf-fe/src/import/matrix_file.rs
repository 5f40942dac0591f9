//! A square matrix file of any kind, told apart by its first bytes.

use std::path::Path;

use super::node_table::NodeLookup;
use super::raw_matrix::RawMatrix;
use super::source::Source;
use super::{listed_matrix, matrix_market, numpy};
use crate::FeError;

/// Reads Matrix Market, NumPy and headerless lists.
pub(crate) fn read(path: &Path, nodes: &NodeLookup) -> Result<RawMatrix, FeError> {
    let source = Source::read(path)?;
    let bytes = source.bytes();
    if matrix_market::is_matrix_market(bytes) {
        matrix_market::read_square(source)
    } else if bytes.starts_with(numpy::NPY_MAGIC) || bytes.starts_with(numpy::NPZ_MAGIC) {
        numpy::read_square(source)
    } else {
        listed_matrix::read(source, nodes)
    }
}
