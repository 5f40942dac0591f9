//! Matrix Market files, coordinate and array, real and integer, general and symmetric.

use crate::import::ImportError;
use crate::import::matrix::entries::{Entries, offset_of_data_line};
use crate::import::matrix::line::{RowNumber, skip_blank_or_comment};
use crate::import::matrix::raw_matrix::{Dense, Numbering, RawMatrix, ShapeCheck, Storage};
use crate::import::text::cursor::{Cursor, DefectKind};
use crate::import::text::source::Source;

/// True if the file is to be read as Matrix Market. The banner starts with `%%MatrixMarket`; two percent signs
/// are enough, so that a file with a damaged banner is not taken for a list with its size line as an entry.
pub(crate) fn is_matrix_market(bytes: &[u8]) -> bool {
    bytes.starts_with(b"%%")
}

/// The banner line and the size line.
#[derive(Debug)]
struct Header {
    array: bool,
    symmetric: bool,
    rows: usize,
    columns: usize,
    /// Number of values that must follow.
    stored: usize,
    /// Offset of the first line after the size line.
    data: usize,
}

/// Reads a square matrix as listed entries.
pub(crate) fn read_square(source: Source) -> Result<RawMatrix, ImportError> {
    let header = read_header(&source)?;
    let size = RawMatrix::square(&source, header.rows, header.columns)?;
    let storage = if header.symmetric { Storage::OneTriangle } else { Storage::Full };
    let entries = if header.array {
        let values = read_values(&source, &header)?;
        let (mut rows, mut columns) = (Vec::new(), Vec::new());
        for column in 0..size {
            for row in if header.symmetric { column } else { 0 }..size {
                // Sizes are checked against u32 in the header.
                rows.push(row as u32);
                columns.push(column as u32);
            }
        }
        Entries::from_vectors(rows, columns, values)
    } else {
        read_coordinates(&source, &header)?
    };
    Ok(RawMatrix { source, entries, size, storage, numbering: Numbering::Declared })
}

/// Reads a matrix of any shape into dense columns. `check` sees the shape before anything is allocated.
pub(crate) fn read_dense(source: &Source, check: &ShapeCheck<'_>) -> Result<Dense, ImportError> {
    let header = read_header(source)?;
    let (rows, columns) = (header.rows, header.columns);
    check(rows, columns)?;
    if header.array && !header.symmetric {
        return Ok(Dense { rows, columns, values: read_values(source, &header)? });
    }
    let mut dense = vec![0.0; rows * columns];
    if header.array {
        let mut values = read_values(source, &header)?.into_iter();
        for column in 0..columns {
            for (row, value) in (column..rows).zip(values.by_ref()) {
                dense[column * rows + row] = value;
                dense[row * rows + column] = value;
            }
        }
    } else {
        for (row, column, value) in read_coordinates(source, &header)?.iter() {
            dense[column * rows + row] += value;
            if header.symmetric && row != column {
                dense[row * rows + column] += value;
            }
        }
    }
    Ok(Dense { rows, columns, values: dense })
}

fn read_header(source: &Source) -> Result<Header, ImportError> {
    let bytes = source.bytes();
    let mut cursor = Cursor::new(bytes, 0);
    cursor.next_line();
    let banner = String::from_utf8_lossy(&bytes[..cursor.at]).to_lowercase();
    let words: Vec<&str> = banner.split_whitespace().collect();
    let expected = "`%%MatrixMarket matrix coordinate|array real|integer general|symmetric`";
    let &["%%matrixmarket", "matrix", format, field, symmetry] = words.as_slice() else {
        return Err(source.expected(0, expected));
    };
    let known = matches!(format, "coordinate" | "array")
        && matches!(field, "real" | "double" | "integer")
        && matches!(symmetry, "general" | "symmetric");
    if !known {
        return Err(source.expected(0, expected));
    }
    let (array, symmetric) = (format == "array", symmetry == "symmetric");
    while cursor.at < bytes.len() && skip_blank_or_comment(bytes, &mut cursor) {}
    let sizes = if array { "the size line `rows columns`" } else { "the size line `rows columns entries`" };
    let mut number = || -> Result<usize, ImportError> {
        cursor.skip_separators();
        let at = cursor.at;
        let number = cursor.unsigned(sizes).map_err(|defect| source.defect(&defect, 0))?;
        // Row numbers are kept in 32 bits.
        let expected = || format!("{sizes}, each at most {}", u32::MAX);
        u32::try_from(number).map(|number| number as usize).map_err(|_| source.expected(at, expected()))
    };
    let (rows, columns) = (number()?, number()?);
    if symmetric {
        RawMatrix::square(source, rows, columns)?;
    }
    let stored = match (array, symmetric) {
        (false, _) => number()?,
        (true, true) => rows * (rows + 1) / 2,
        (true, false) => rows * columns,
    };
    cursor.end_line(sizes).map_err(|defect| source.defect(&defect, 0))?;
    Ok(Header { array, symmetric, rows, columns, stored, data: cursor.at })
}

fn read_coordinates(source: &Source, header: &Header) -> Result<Entries, ImportError> {
    let limit = header.rows.max(header.columns);
    let entries = Entries::read(source.bytes(), header.data, &RowNumber { limit })
        .map_err(|defect| cut_or_defect(source, header, &defect))?;
    let at = |entry| offset_of_data_line(source.bytes(), header.data, entry);
    if entries.len() < header.stored {
        return Err(source.truncated("entries", header.stored, entries.len()));
    }
    if entries.len() > header.stored {
        let expected = format!("the end of the file after {} entries", header.stored);
        return Err(source.expected(at(header.stored), expected));
    }
    if header.rows != header.columns {
        let outside =
            entries.iter().position(|(row, column, _)| row >= header.rows || column >= header.columns);
        if let Some(entry) = outside {
            let expected = format!("a row up to {} and a column up to {}", header.rows, header.columns);
            return Err(source.expected(at(entry), expected));
        }
    }
    let order = entries.order();
    if header.symmetric && order.below && order.above {
        let side = entries.iter().map(|(row, column, _)| row.cmp(&column)).find(|side| side.is_ne());
        let stray = entries
            .iter()
            .position(|(row, column, _)| side.is_some_and(|side| row.cmp(&column) == side.reverse()));
        if let Some(entry) = stray {
            return Err(
                source.expected(at(entry), "all entries in the same triangle (the header says symmetric)")
            );
        }
    }
    Ok(entries)
}

/// A defect in the last line of a file that is too short is a cut, and is called so.
fn cut_or_defect(
    source: &Source,
    header: &Header,
    defect: &crate::import::text::cursor::Defect,
) -> ImportError {
    let bytes = source.bytes();
    let last = source.line_of(defect.at) == source.last_line();
    if last && !bytes.ends_with(b"\n") && matches!(defect.kind, DefectKind::Expected(_)) {
        let line = bytes[..defect.at].iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
        let mut found = 0;
        let mut cursor = Cursor::new(bytes, header.data);
        while cursor.at < line {
            if !skip_blank_or_comment(bytes, &mut cursor) {
                found += 1;
                cursor.next_line();
            }
        }
        return source.truncated("entries", header.stored, found);
    }
    source.defect(defect, 0)
}

/// The values of an array file, one a line (several a line are accepted).
fn read_values(source: &Source, header: &Header) -> Result<Vec<f64>, ImportError> {
    let bytes = source.bytes();
    let mut values = Vec::with_capacity(header.stored.min(bytes.len()));
    let mut cursor = Cursor::new(bytes, header.data);
    while cursor.at < bytes.len() {
        if skip_blank_or_comment(bytes, &mut cursor) {
            continue;
        }
        if values.len() == header.stored {
            let expected = format!("the end of the file after {} values", header.stored);
            return Err(source.expected(cursor.at, expected));
        }
        values.push(cursor.float("a number").map_err(|defect| source.defect(&defect, 0))?);
    }
    if values.len() < header.stored {
        return Err(source.truncated("values", header.stored, values.len()));
    }
    Ok(values)
}
