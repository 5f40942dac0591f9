//! Nastran matrices of `OUTPUT4`, text or binary, by columns or by strings of entries.
//!
//! Source: MSC Nastran DMAP Programmer's Guide, module OUTPUT4, "Format of the output file". Rows are counted as in the file: the degrees
//! of freedom of the grid points in ascending order, three or six each.

use super::op4_binary::{self, is_binary};
use super::op4_header::{Header, Visitor};
use super::op4_text::{self, is_text};
use crate::import::ImportError;
use crate::import::matrix::entries::Entries;
use crate::import::matrix::raw_matrix::{Dense, MatrixRole, Numbering, RawMatrix, ShapeCheck, Storage};
use crate::import::nodes::NodeLookup;
use crate::import::text::source::Source;

/// Types of real numbers, single and double.
const REAL: [u64; 2] = [1, 2];

/// True for a file of `OUTPUT4`, text or binary.
pub(crate) fn is_op4(bytes: &[u8]) -> bool {
    is_text(bytes) || is_binary(bytes)
}

fn visit(source: &Source, visitor: &mut impl Visitor) -> Result<(), ImportError> {
    if is_binary(source.bytes()) {
        op4_binary::visit(source, visitor)
    } else {
        op4_text::visit(source, visitor)
    }
}

/// Names of all matrices.
struct Names(Vec<(String, usize)>);

impl Visitor for Names {
    fn begins(&mut self, header: &Header) -> Result<bool, ImportError> {
        self.0.push((header.name.clone(), header.place));
        Ok(false)
    }

    fn entry(&mut self, _: usize, _: usize, _: f64, _: usize) -> Result<(), ImportError> {
        Ok(())
    }
}

/// Entries of the matrix at one place.
struct Chosen<'a> {
    source: &'a Source,
    place: usize,
    nodes: usize,
    size: usize,
    /// Six rows a grid point, of which the last three must be empty.
    has_rotations: bool,
    rows: Vec<u32>,
    columns: Vec<u32>,
    values: Vec<f64>,
}

impl Visitor for Chosen<'_> {
    fn begins(&mut self, header: &Header) -> Result<bool, ImportError> {
        if header.place != self.place {
            return Ok(false);
        }
        if !REAL.contains(&header.kind) {
            return Err(self.source.expected(header.place, "a real matrix, type 1 or 2"));
        }
        self.size = RawMatrix::square(self.source, header.rows, header.columns)?;
        self.has_rotations = self.nodes > 0 && self.size == 6 * self.nodes;
        Ok(true)
    }

    fn entry(&mut self, row: usize, column: usize, value: f64, place: usize) -> Result<(), ImportError> {
        if !value.is_finite() {
            let text = format!("a finite number in row {row} of column {column}, found {value}");
            return Err(self.source.expected(place, text));
        }
        let (mut row, mut column) = (row - 1, column - 1);
        if self.has_rotations {
            if row % 6 > 2 || column % 6 > 2 {
                if value == 0.0 {
                    return Ok(());
                }
                let text = format!(
                    "six rows a grid point of which those of rotations are empty, as of solids, found {value:e} in row {} of column {}",
                    row + 1,
                    column + 1
                );
                return Err(self.source.expected(place, text));
            }
            (row, column) = (row / 6 * 3 + row % 6, column / 6 * 3 + column % 6);
        }
        // sizes are below 2^32, see the headers
        self.rows.push(row as u32);
        self.columns.push(column as u32);
        self.values.push(value);
        Ok(())
    }
}

/// Reads the matrix of a role; `nodes` tells whether a grid point has three rows or six.
pub(crate) fn read(source: Source, nodes: &NodeLookup, role: MatrixRole) -> Result<RawMatrix, ImportError> {
    let mut names = Names(Vec::new());
    visit(&source, &mut names)?;
    let at = super::chosen(&source, &names.0, role)?;
    let mut chosen = Chosen {
        source: &source,
        place: names.0[at].1,
        nodes: nodes.len(),
        size: 0,
        has_rotations: false,
        rows: Vec::new(),
        columns: Vec::new(),
        values: Vec::new(),
    };
    visit(&source, &mut chosen)?;
    let Chosen { size, has_rotations, rows, columns, values, .. } = chosen;
    let size = if has_rotations { size / 2 } else { size };
    let entries = Entries::from_vectors(rows, columns, values);
    Ok(RawMatrix { source, entries, size, storage: Storage::Undeclared, numbering: Numbering::Declared })
}

/// Such a file is read as mass or stiffness.
pub(crate) fn refuse_dense(source: &Source, _: &ShapeCheck<'_>) -> Result<Dense, ImportError> {
    Err(source.expected(0, "columns of numbers (matrices of OUTPUT4 are read as mass or stiffness)"))
}
