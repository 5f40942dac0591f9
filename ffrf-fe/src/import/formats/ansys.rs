//! ANSYS: the node table of the workbench and the mapping vector of `*SMAT`.
//!
//! The mapping vector names, for each block of three rows of the matrices, the node that the block belongs to. It
//! is a Matrix Market array with one column (or a plain list).

use super::matrix_market;
use crate::Nodes;
use crate::import::ImportError;
use crate::import::matrix::line::skip_blank_or_comment;
use crate::import::nodes::{NodeLookup, NodeTable};
use crate::import::text::cursor::Cursor;
use crate::import::text::source::Source;

const LINE: &str = "`id x y z` with decimal points or decimal commas";

/// Reads the table `id x y z`. Header lines in any language are skipped; a comma is a decimal comma where the
/// columns are divided by tabs, semicolons or blanks, and a separator otherwise.
pub(crate) fn read_nodes(source: &Source) -> Result<NodeTable, ImportError> {
    let mut nodes = Nodes::default();
    let mut seen = std::collections::HashMap::new();
    for (at, line) in lines(source.bytes()) {
        let fields = fields(line);
        let starts_with_number = fields
            .first()
            .is_some_and(|field| field.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)));
        if fields.is_empty() || (nodes.is_empty() && !starts_with_number) {
            continue;
        }
        let [id, x, y, z] = fields.as_slice() else {
            return Err(source.expected(at, LINE));
        };
        let id: u64 = id.parse().map_err(|_| source.expected(at, LINE))?;
        let mut position = [0.0; 3];
        for (coordinate, field) in position.iter_mut().zip([x, y, z]) {
            let mut number = Cursor::new(field.as_bytes(), 0);
            let read = number.float(LINE).and_then(|value| number.end_line(LINE).map(|()| value));
            *coordinate = read.map_err(|mut defect| {
                defect.at = at;
                source.defect(&defect, 0)
            })?;
        }
        if seen.insert(id, ()).is_some() {
            return Err(ImportError::DuplicateNode {
                path: source.path().to_path_buf(),
                line: source.line_of(at),
                id,
            });
        }
        nodes.ids.push(id);
        nodes.positions.push(position);
    }
    NodeTable { nodes, ..NodeTable::default() }.check_size(source)
}

/// SparseLines with their byte offsets.
fn lines(bytes: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    let mut at = 0;
    bytes.split_inclusive(|&byte| byte == b'\n').map(move |line| {
        let start = at;
        at += line.len();
        (start, line)
    })
}

fn fields(line: &[u8]) -> Vec<String> {
    let text = String::from_utf8_lossy(line);
    let text = text.trim();
    let by_blanks: Vec<&str> = text.split([' ', '\t', ';']).filter(|field| !field.is_empty()).collect();
    // `1, 0.5, 0.5, 0.5` leaves a comma at the end of the id, `1,0.5,0.5,0.5` no blank at all.
    let decimal_commas = by_blanks.len() >= 4 && by_blanks.first().is_some_and(|id| !id.ends_with(','));
    if decimal_commas {
        by_blanks.into_iter().map(|field| field.replace(',', ".")).collect()
    } else {
        let separators = |c: char| c == ',' || c == ';' || c.is_whitespace();
        text.split(separators).filter(|field| !field.is_empty()).map(str::to_owned).collect()
    }
}

/// Puts the nodes into the order of the matrices' blocks.
pub(crate) fn order_by_mapping(table: NodeTable, mapping: &Source) -> Result<NodeTable, ImportError> {
    let lookup = NodeLookup::new(&table.nodes.ids);
    let labels = read_mapping(mapping)?;
    if labels.len() != table.nodes.len() {
        return Err(ImportError::SizeMismatch {
            path: mapping.path().to_path_buf(),
            expected: format!("one entry for each of the {} nodes of the node table", table.nodes.len()),
            found: labels.len(),
            what: "entries",
        });
    }
    let mut nodes = Nodes::default();
    let mut used = vec![false; labels.len()];
    for (at, label) in labels {
        let path = || mapping.path().to_path_buf();
        let Some(row) = lookup.row(label) else {
            let line = mapping.line_of(at);
            return Err(ImportError::UnknownNode { path: path(), line, id: label, nodes: table.nodes.len() });
        };
        if std::mem::replace(&mut used[row], true) {
            return Err(mapping.expected(at, format!("each node once (node {label} stands here again)")));
        }
        nodes.ids.push(label);
        nodes.positions.push(table.nodes.positions[row]);
    }
    Ok(NodeTable { nodes, ..table })
}

/// Node labels with the offsets where they stand.
fn read_mapping(source: &Source) -> Result<Vec<(usize, u64)>, ImportError> {
    let bytes = source.bytes();
    let expected = "one node id a line";
    let mut labels = Vec::new();
    let mut cursor = Cursor::new(bytes, 0);
    let mut announced = None;
    if matrix_market::is_matrix_market(bytes) {
        while cursor.at < bytes.len() && skip_blank_or_comment(bytes, &mut cursor) {}
        let at = cursor.at;
        let size = "the size line `nodes 1`";
        let mut number = || cursor.unsigned(size).map_err(|defect| source.defect(&defect, 0));
        let (rows, columns) = (number()?, number()?);
        if columns != 1 {
            return Err(source.expected(at, size));
        }
        announced = usize::try_from(rows).ok();
        cursor.end_line(size).map_err(|defect| source.defect(&defect, 0))?;
    }
    while cursor.at < bytes.len() {
        if skip_blank_or_comment(bytes, &mut cursor) {
            continue;
        }
        let at = cursor.at;
        // Integers may be printed as floats.
        let label = cursor.float(expected).map_err(|defect| source.defect(&defect, 0))?;
        cursor.end_line(expected).map_err(|defect| source.defect(&defect, 0))?;
        if label < 0.0 || label.fract() != 0.0 || label > u32::MAX.into() {
            return Err(source.expected(at, expected));
        }
        labels.push((at, label as u64));
    }
    match announced {
        Some(announced) if announced > labels.len() => {
            Err(source.truncated("nodes", announced, labels.len()))
        }
        Some(announced) if announced < labels.len() => Err(source.expected(
            labels.get(announced).map_or(0, |label| label.0),
            format!("the end of the file after {announced} nodes"),
        )),
        _ => Ok(labels),
    }
}
