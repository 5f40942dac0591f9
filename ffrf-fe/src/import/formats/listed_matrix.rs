//! Matrix entries without header: Abaqus `*MATRIX GENERATE` and CalculiX `.sti`, `.mas`.
//!
//! Two kinds of line: `row column value`, and `node dof node dof value`; blanks or commas between.

use crate::import::ImportError;
use crate::import::matrix::entries::Entries;
use crate::import::matrix::line::{ReadIndex, RowNumber, skip_blank_or_comment};
use crate::import::matrix::raw_matrix::{Numbering, RawMatrix, Storage};
use crate::import::nodes::NodeLookup;
use crate::import::text::cursor::{Cursor, Defect, DefectKind};
use crate::import::text::ordinary;
use crate::import::text::source::Source;

/// SparseLines before the last that show how long a value is printed in this file.
const SAMPLE_LINES: usize = 20;

/// A node label and a direction 1 to 3.
struct LabelAndDirection<'a> {
    nodes: &'a NodeLookup,
}

impl ReadIndex for LabelAndDirection<'_> {
    const LINE: &'static str = "`node dof node dof value` with dof 1 to 3";

    #[inline(always)]
    fn read_short(&self, bytes: &[u8], at: usize) -> Option<(u32, usize)> {
        let (label, at) = ordinary::index(bytes, at)?;
        let (direction, at) = ordinary::index(bytes, at)?;
        let row = self.nodes.row(label.into())?;
        // Rows are below 2^32 / 3, see `NodeTable::check_size`.
        (1..=3).contains(&direction).then(|| (3 * row as u32 + direction - 1, at))
    }

    fn read(&self, cursor: &mut Cursor<'_>) -> Result<u32, Defect> {
        cursor.skip_separators();
        let at = cursor.at;
        let label = cursor.unsigned(Self::LINE)?;
        let Some(row) = self.nodes.row(label) else {
            return Err(Defect { at, kind: DefectKind::UnknownNode(label) });
        };
        cursor.skip_separators();
        let at = cursor.at;
        match cursor.unsigned(Self::LINE)? {
            direction @ 1..=3 => Ok((3 * row + direction as usize - 1) as u32),
            _ => Err(Defect { at, kind: DefectKind::Expected(Self::LINE) }),
        }
    }
}

/// Reads a list; labels are looked up in `nodes`.
pub(crate) fn read(source: Source, nodes: &NodeLookup) -> Result<RawMatrix, ImportError> {
    let bytes = source.bytes();
    let (line, columns) = first_line(bytes);
    let read = match columns {
        3 => Entries::read(bytes, 0, &RowNumber { limit: u32::MAX as usize }),
        5 => Entries::read(bytes, 0, &LabelAndDirection { nodes }),
        _ => {
            let expected = "`row column value` or `node dof node dof value` or a Matrix Market or NumPy file";
            return Err(source.expected(line, expected));
        }
    };
    let entries = read.map_err(|defect| source.defect(&defect, nodes.len()))?;
    refuse_cut_number(&source)?;
    refuse_size_line(&source, line, &entries)?;
    let (numbering, size) = match columns {
        3 => (Numbering::Listed, entries.extent()),
        _ => (Numbering::Labelled, 3 * nodes.len()),
    };
    Ok(RawMatrix { source, entries, size, storage: Storage::Undeclared, numbering })
}

/// Offset and number of columns of the first data line.
fn first_line(bytes: &[u8]) -> (usize, usize) {
    let mut cursor = Cursor::new(bytes, 0);
    while cursor.at < bytes.len() && skip_blank_or_comment(bytes, &mut cursor) {}
    let start = cursor.at;
    cursor.next_line();
    (start, tokens(&bytes[start..cursor.at]).count())
}

fn tokens(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|byte| matches!(byte, b' ' | b'\t' | b',' | b'\r' | b'\n')).filter(|token| !token.is_empty())
}

/// Refuses a first line `n n count` that is the size line of a Matrix Market file without its banner: three integers
/// among values with a decimal point or exponent, or with the number of lines that follow as the value.
fn refuse_size_line(source: &Source, at: usize, entries: &Entries) -> Result<(), ImportError> {
    let first = entries.iter().next();
    let Some((row, column, value)) = first.filter(|_| entries.len() > 1) else { return Ok(()) };
    let bytes = source.bytes();
    let integer = |line: &[u8]| {
        let value = tokens(line).last().unwrap_or_default();
        !value.is_empty() && value.iter().all(u8::is_ascii_digit)
    };
    let mut lines = bytes[at..].split(|&byte| byte == b'\n');
    if !lines.next().is_some_and(integer) {
        return Ok(());
    }
    let alone = !lines.filter(|line| tokens(line).next().is_some()).take(SAMPLE_LINES).any(integer);
    let counts = value == (entries.len() - 1) as f64;
    let largest = row == column && row + 1 == entries.extent();
    if largest && (alone || counts) {
        let expected = "`row column value` (this looks like the size line of a Matrix Market file whose first line, \
                        `%%MatrixMarket matrix ...`, is missing)";
        return Err(source.expected(at, expected));
    }
    Ok(())
}

/// A list has no count, so a cut within its last number would pass as another number. FE codes print all
/// values of a file to the same length and end the last line: a last line without end whose value is shorter
/// than all others is a cut.
fn refuse_cut_number(source: &Source) -> Result<(), ImportError> {
    let bytes = source.bytes();
    if bytes.ends_with(b"\n") {
        return Ok(());
    }
    let length = |line: &[u8]| {
        let value = tokens(line).last().unwrap_or_default();
        value.strip_prefix(b"-").unwrap_or(value).len()
    };
    let mut lines = bytes.rsplit(|&byte| byte == b'\n');
    let last = length(lines.next().unwrap_or_default());
    let mut sample = lines.take(SAMPLE_LINES).map(length).filter(|&length| length > 0);
    let Some(usual) = sample.next() else { return Ok(()) };
    if sample.all(|length| length == usual) && last < usual {
        let expected =
            format!("a value of {usual} characters and a line end, as in the lines before (cut file?)");
        return Err(source.expected(bytes.len() - last, expected));
    }
    Ok(())
}
