//! Plain tables of numbers: one row a line, blanks, tabs or commas between; comments start with `#`, `%` or `*`.

use crate::Nodes;
use crate::import::ImportError;
use crate::import::matrix::line::skip_blank_or_comment;
use crate::import::matrix::raw_matrix::{Dense, ShapeCheck};
use crate::import::nodes::NodeTable;
use crate::import::text::cursor::Cursor;
use crate::import::text::source::Source;

/// Reads a rectangular table, column by column in the result.
pub(crate) fn read_dense(source: &Source, _check: &ShapeCheck<'_>) -> Result<Dense, ImportError> {
    let bytes = source.bytes();
    let mut cursor = Cursor::new(bytes, 0);
    let mut by_rows = Vec::new();
    let (mut rows, mut columns) = (0, 0);
    while cursor.at < bytes.len() {
        if skip_blank_or_comment(bytes, &mut cursor) {
            continue;
        }
        let start = cursor.at;
        let before = by_rows.len();
        while !cursor.at_line_end() {
            by_rows.push(cursor.float("a number").map_err(|defect| source.defect(&defect, 0))?);
            cursor.skip_separators();
        }
        let found = by_rows.len() - before;
        if rows == 0 {
            columns = found;
        } else if found != columns {
            let expected = format!("{columns} numbers as in the lines before (here: {found})");
            return Err(source.expected(start, expected));
        }
        rows += 1;
        cursor.next_line();
    }
    let values = (0..rows * columns).map(|place| by_rows[place % rows * columns + place / rows]).collect();
    Ok(Dense { rows, columns, values })
}

/// Reads `x y z` a line; ids are row numbers from 0.
pub(crate) fn read_nodes(source: &Source) -> Result<NodeTable, ImportError> {
    let bytes = source.bytes();
    let mut cursor = Cursor::new(bytes, 0);
    let mut positions = Vec::new();
    while cursor.at < bytes.len() {
        if skip_blank_or_comment(bytes, &mut cursor) {
            continue;
        }
        let mut position = [0.0; 3];
        let line = "three coordinates `x y z`";
        for coordinate in &mut position {
            *coordinate = cursor.float(line).map_err(|defect| source.defect(&defect, 0))?;
        }
        cursor.end_line(line).map_err(|defect| source.defect(&defect, 0))?;
        positions.push(position);
    }
    plain_nodes(positions).check_size(source)
}

/// Nodes numbered from 0.
pub(crate) fn plain_nodes(positions: Vec<[f64; 3]>) -> NodeTable {
    let ids = (0..positions.len() as u64).collect();
    NodeTable { nodes: Nodes { ids, positions, ..Nodes::default() }, ..NodeTable::default() }
}
