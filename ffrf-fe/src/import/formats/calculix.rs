//! CalculiX: the deck beside `.sti`, `.mas` and `.dof` of `*FREQUENCY, SOLVER=MATRIXSTORAGE`.
//!
//! The `.dof` file names the degree of freedom of each matrix row as `node.direction`; those that boundary
//! conditions hold, and those of nodes without elements, are absent.

use std::path::Path;

use super::matrix_file;
use crate::import::ImportError;
use crate::import::error::shown;
use crate::import::matrix::line::skip_blank_or_comment;
use crate::import::matrix::raw_matrix::{MatrixRole, Numbering, RawMatrix};
use crate::import::nodes::NodeLookup;
use crate::import::text::cursor::Cursor;
use crate::import::text::source::Source;

/// Degree of freedom 3 n + i of each matrix row.
#[derive(Debug)]
pub(crate) struct RowMap {
    pub(crate) source: Source,
    pub(crate) dofs: Vec<u32>,
}

/// Reads a `.dof` file.
pub(crate) fn read_row_map(
    path: &Path,
    nodes: &NodeLookup,
    inflated_limit: u64,
) -> Result<RowMap, ImportError> {
    let source = Source::read(path, inflated_limit)?;
    let bytes = source.bytes();
    let expected = "`node.direction` with direction 1 to 3";
    let mut dofs = Vec::new();
    let mut used = vec![false; 3 * nodes.len()];
    let mut cursor = Cursor::new(bytes, 0);
    while cursor.at < bytes.len() {
        if skip_blank_or_comment(bytes, &mut cursor) {
            continue;
        }
        let start = cursor.at;
        cursor.next_line();
        let line = String::from_utf8_lossy(&bytes[start..cursor.at]);
        let parsed = line.trim().split_once('.').and_then(|(node, direction)| {
            Some((node.parse::<u64>().ok()?, direction.parse::<usize>().ok()?))
        });
        let Some((label, direction @ 1..=3)) = parsed else {
            return Err(source.expected(start, expected));
        };
        let Some(row) = nodes.row(label) else {
            return Err(ImportError::UnknownNode {
                path: path.to_path_buf(),
                line: source.line_of(start),
                id: label,
                nodes: nodes.len(),
            });
        };
        let dof = 3 * row + direction - 1;
        if std::mem::replace(&mut used[dof], true) {
            return Err(source.expected(start, "each degree of freedom once"));
        }
        // Node tables hold fewer than 2^32 / 3 nodes.
        dofs.push(dof as u32);
    }
    Ok(RowMap { source, dofs })
}

/// Reads `.sti` or `.mas` and moves its rows to the degrees of freedom of the node table.
pub(crate) fn read_matrix(
    source: Source,
    nodes: &NodeLookup,
    map: &RowMap,
    role: MatrixRole,
) -> Result<RawMatrix, ImportError> {
    let path = source.path().to_path_buf();
    let mut matrix = matrix_file::read_square(source, nodes, role)?;
    if matrix.numbering != Numbering::Listed {
        return Ok(matrix);
    }
    if matrix.size != map.dofs.len() {
        return Err(ImportError::SizeMismatch {
            path,
            expected: format!("a matrix of {} rows, as {} lists", map.dofs.len(), shown(map.source.path())),
            found: matrix.size,
            what: "rows",
        });
    }
    matrix.entries.renumber(&map.dofs);
    matrix.size = 3 * nodes.len();
    matrix.numbering = Numbering::Named;
    Ok(matrix)
}
