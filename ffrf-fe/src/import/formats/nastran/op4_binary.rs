//! `OUTPUT4` in records of Fortran, of either byte order.

use super::op4_header::{Header, Visitor};
use crate::import::ImportError;
use crate::import::text::source::Source;

/// Length of the record before a matrix: four integers and a name of eight characters.
const HEADER: usize = 24;

/// True if the first record is the header of a matrix.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    [false, true].into_iter().any(|is_big_endian| {
        let records = Records { bytes, at: 0, is_big_endian };
        records.number(0) == Some(HEADER as u64) && records.number(4 + HEADER) == Some(HEADER as u64)
    })
}

/// Walks over all matrices.
pub(super) fn visit(source: &Source, visitor: &mut impl Visitor) -> Result<(), ImportError> {
    let bytes = source.bytes();
    let is_big_endian = bytes.first() == Some(&0);
    let mut records = Records { bytes, at: 0, is_big_endian };
    while records.at < bytes.len() {
        let place = records.at;
        let header = records.next(source)?;
        let Some(header) = parse_header(header, is_big_endian, place) else {
            return Err(binary(source, place, "columns, rows, form, type and name of a matrix in 24 bytes"));
        };
        let wanted = visitor.begins(&header)?;
        loop {
            let place = records.at;
            if place >= bytes.len() {
                let text = format!("column {} that ends the matrix `{}`", header.columns + 1, header.name);
                return Err(binary(source, place, &text));
            }
            let record = records.next(source)?;
            let integers = [0, 4, 8].map(|at| record.integer(at));
            let [Some(column), Some(row), Some(words)] = integers else {
                return Err(binary(source, place, "column, row and number of words"));
            };
            if column == 0 || column > header.columns as u64 + 1 {
                return Err(binary(source, place, &format!("a column from 1 to {}", header.columns + 1)));
            }
            if column > header.columns as u64 {
                break;
            }
            if record.bytes.len() as u64 != 12 + 4 * words {
                return Err(binary(
                    source,
                    place,
                    &format!("{words} words in the record of column {column}"),
                ));
            }
            let mut column =
                Column { source, header: &header, column: column as usize, wanted, record, place };
            if row > 0 {
                column.string(row as usize, 12, words as usize, visitor)?;
            } else {
                column.strings(visitor)?;
            }
        }
    }
    Ok(())
}

fn parse_header(record: Record<'_>, is_big_endian: bool, place: usize) -> Option<Header> {
    if record.bytes.len() != HEADER {
        return None;
    }
    let number = |at: usize| {
        let bytes: [u8; 4] = record.bytes.get(at..at + 4)?.try_into().ok()?;
        Some(if is_big_endian { i32::from_be_bytes(bytes) } else { i32::from_le_bytes(bytes) })
    };
    let (columns, rows, kind) = (number(0)?, number(4)?, number(12)?);
    let name = record.bytes.get(16..24)?;
    let size = |number: i32| usize::try_from(number).ok().filter(|&size| size > 0);
    Some(Header {
        name: String::from_utf8_lossy(name).trim().to_owned(),
        rows: size(rows.checked_abs()?)?,
        columns: size(columns)?,
        kind: u64::try_from(kind).ok().filter(|kind| (1..=4).contains(kind))?,
        is_big: rows < 0,
        place,
    })
}

/// An error about a place in a binary file.
fn binary(source: &Source, place: usize, expected: &str) -> ImportError {
    ImportError::Array {
        path: source.path().to_path_buf(),
        array: String::new(),
        expected: format!("{expected} at byte {place}"),
        found: "something else".to_owned(),
    }
}

struct Column<'c, 's> {
    source: &'s Source,
    header: &'c Header,
    column: usize,
    wanted: bool,
    record: Record<'s>,
    place: usize,
}

impl Column<'_, '_> {
    /// Strings of entries behind their lengths and first rows.
    fn strings(&mut self, visitor: &mut impl Visitor) -> Result<(), ImportError> {
        let mut at = 12;
        while at < self.record.bytes.len() {
            let string = if self.header.is_big {
                let words = self.record.integer(at).and_then(|length| length.checked_sub(1));
                words
                    .zip(self.record.integer(at + 4))
                    .map(|(words, row)| (row as usize, words as usize, at + 8))
            } else {
                let string = self.record.integer(at).and_then(Header::small_string);
                string.map(|(row, words)| (row, words, at + 4))
            };
            let Some((row, words, from)) = string.filter(|&(row, words, _)| row > 0 && words > 0) else {
                return Err(binary(
                    self.source,
                    self.place,
                    "length and row of a string of entries in a column",
                ));
            };
            self.string(row, from, words, visitor)?;
            at = from + 4 * words;
        }
        Ok(())
    }

    fn string(
        &mut self,
        row: usize,
        from: usize,
        words: usize,
        visitor: &mut impl Visitor,
    ) -> Result<(), ImportError> {
        let number = self.header.words();
        let count = words / number;
        let bytes = self.record.bytes.get(from..).and_then(|bytes| bytes.get(..4 * words));
        let is_inside = count <= self.header.rows && row <= self.header.rows + 1 - count.max(1);
        let (Some(bytes), true) = (bytes, is_inside && words.is_multiple_of(number)) else {
            let text = format!("rows from 1 to {} in column {}", self.header.rows, self.column);
            return Err(binary(self.source, self.place, &text));
        };
        if !self.wanted {
            return Ok(());
        }
        for (at, bytes) in bytes.chunks_exact(4 * number).enumerate() {
            let mut bits = [0; 8];
            let length = bytes.len().min(8);
            bits[..length].copy_from_slice(&bytes[..length]);
            let value = match (number, self.record.is_big_endian) {
                (1, true) => f64::from(f32::from_be_bytes([bits[0], bits[1], bits[2], bits[3]])),
                (1, false) => f64::from(f32::from_le_bytes([bits[0], bits[1], bits[2], bits[3]])),
                (_, true) => f64::from_be_bytes(bits),
                (_, false) => f64::from_le_bytes(bits),
            };
            visitor.entry(row + at, self.column, value, self.place)?;
        }
        Ok(())
    }
}

/// One record between its lengths.
#[derive(Clone, Copy)]
struct Record<'a> {
    bytes: &'a [u8],
    is_big_endian: bool,
}

impl Record<'_> {
    /// An integer of four bytes.
    fn integer(&self, at: usize) -> Option<u64> {
        Records { bytes: self.bytes, at: 0, is_big_endian: self.is_big_endian }.number(at)
    }
}

struct Records<'a> {
    bytes: &'a [u8],
    at: usize,
    is_big_endian: bool,
}

impl<'a> Records<'a> {
    fn number(&self, at: usize) -> Option<u64> {
        let bytes: [u8; 4] = self.bytes.get(at..)?.get(..4)?.try_into().ok()?;
        let number = if self.is_big_endian { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) };
        Some(u64::from(number))
    }

    fn next(&mut self, source: &Source) -> Result<Record<'a>, ImportError> {
        let place = self.at;
        let length = self.number(place).and_then(|length| usize::try_from(length).ok());
        let end = length.and_then(|length| place.checked_add(length)?.checked_add(4));
        match (length, end.and_then(|end| self.number(end)), end) {
            (Some(length), Some(again), Some(end)) if again == length as u64 => {
                self.at = end + 4;
                let bytes = &self.bytes[place + 4..end];
                Ok(Record { bytes, is_big_endian: self.is_big_endian })
            }
            _ => Err(binary(source, place, "a whole record of Fortran between two equal lengths")),
        }
    }
}
