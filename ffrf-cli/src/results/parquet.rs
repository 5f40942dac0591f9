//! Apache Parquet: one row group, plain doubles, no compression.
//!
//! The format holds far more than samples need; this is the part that every reader must know: required columns of doubles in
//! data pages of version 1, described in Thrift's compact protocol.
//! Source: apache/parquet-format, `parquet.thrift` (field numbers), `Encodings.md`; apache/thrift, `thrift-compact-protocol.md`.

use super::Columns;

const MAGIC: &[u8] = b"PAR1";
/// Rows of one page: half a megabyte.
const PAGE_ROWS: usize = 65_536;
/// Physical type DOUBLE.
const DOUBLE: i64 = 5;
/// Encodings PLAIN and RLE.
const PLAIN: i64 = 0;
const RLE: i64 = 3;

/// The bytes of a file.
pub(super) fn encode(columns: &Columns) -> Vec<u8> {
    let mut file = MAGIC.to_vec();
    let row_count = columns.rows.len() as i64;
    let chunks: Vec<Compact> = columns
        .names
        .iter()
        .enumerate()
        .map(|(index, name)| {
            let start = file.len();
            pages(columns, index, &mut file);
            chunk(name, start as i64, (file.len() - start) as i64, row_count)
        })
        .collect();
    let total = (file.len() - MAGIC.len()) as i64;
    let mut schema = vec![Compact::default().text(4, "samples").number(5, I32, columns.names.len() as i64)];
    // a required double: type, repetition, name
    schema.extend(
        columns
            .names
            .iter()
            .map(|name| Compact::default().number(1, I32, DOUBLE).number(3, I32, 0).text(4, name)),
    );
    let group = Compact::default().structs(1, chunks).number(2, I64, total).number(3, I64, row_count);
    let footer = Compact::default()
        .number(1, I32, 1)
        .structs(2, schema)
        .number(3, I64, row_count)
        .structs(4, vec![group])
        .text(6, "ffrf")
        .end();
    file.extend_from_slice(&footer);
    file.extend_from_slice(&(footer.len() as u32).to_le_bytes());
    file.extend_from_slice(MAGIC);
    file
}

fn pages(columns: &Columns, index: usize, file: &mut Vec<u8>) {
    for rows in columns.rows.chunks(PAGE_ROWS) {
        let size = 8 * rows.len() as i64;
        let data = Compact::default()
            .number(1, I32, rows.len() as i64)
            .number(2, I32, PLAIN)
            .number(3, I32, RLE)
            .number(4, I32, RLE);
        let header =
            Compact::default().number(1, I32, 0).number(2, I32, size).number(3, I32, size).inner(5, data);
        file.extend_from_slice(&header.end());
        for row in rows {
            file.extend_from_slice(&row.get(index).copied().unwrap_or(f64::NAN).to_le_bytes());
        }
    }
}

fn chunk(name: &str, start: i64, size: i64, values: i64) -> Compact {
    let meta = Compact::default()
        .number(1, I32, DOUBLE)
        .numbers(2, &[PLAIN])
        .texts(3, &[name])
        .number(4, I32, 0)
        .number(5, I64, values)
        .number(6, I64, size)
        .number(7, I64, size)
        .number(9, I64, start);
    Compact::default().number(2, I64, start).inner(3, meta)
}

/// Types of the compact protocol.
const I32: u8 = 5;
const I64: u8 = 6;
const BINARY: u8 = 8;
const LIST: u8 = 9;
const STRUCT: u8 = 12;

/// A struct of the compact protocol while it is written.
#[derive(Default)]
struct Compact {
    bytes: Vec<u8>,
    last: u8,
}

impl Compact {
    /// The head of a field: how far its number is from the last one, and its type.
    fn field(&mut self, number: u8, kind: u8) {
        self.bytes.push((number - self.last) << 4 | kind);
        self.last = number;
    }

    fn number(mut self, field: u8, kind: u8, value: i64) -> Self {
        self.field(field, kind);
        zigzag(&mut self.bytes, value);
        self
    }

    fn text(mut self, field: u8, text: &str) -> Self {
        self.field(field, BINARY);
        binary(&mut self.bytes, text);
        self
    }

    fn inner(mut self, field: u8, inner: Self) -> Self {
        self.field(field, STRUCT);
        self.bytes.extend(inner.end());
        self
    }

    fn list(&mut self, field: u8, kind: u8, length: usize) {
        self.field(field, LIST);
        match u8::try_from(length) {
            Ok(short @ 0..15) => self.bytes.push(short << 4 | kind),
            _ => {
                self.bytes.push(0xf0 | kind);
                varint(&mut self.bytes, length as u64);
            }
        }
    }

    fn numbers(mut self, field: u8, values: &[i64]) -> Self {
        self.list(field, I32, values.len());
        values.iter().for_each(|value| zigzag(&mut self.bytes, *value));
        self
    }

    fn texts(mut self, field: u8, texts: &[&str]) -> Self {
        self.list(field, BINARY, texts.len());
        texts.iter().for_each(|text| binary(&mut self.bytes, text));
        self
    }

    fn structs(mut self, field: u8, structs: Vec<Self>) -> Self {
        self.list(field, STRUCT, structs.len());
        structs.into_iter().for_each(|inner| self.bytes.extend(inner.end()));
        self
    }

    fn end(mut self) -> Vec<u8> {
        self.bytes.push(0);
        self.bytes
    }
}

fn varint(bytes: &mut Vec<u8>, mut value: u64) {
    while value >= 0x80 {
        bytes.push(value as u8 | 0x80);
        value >>= 7;
    }
    bytes.push(value as u8);
}

/// Small numbers of either sign in few bytes.
fn zigzag(bytes: &mut Vec<u8>, value: i64) {
    varint(bytes, (value << 1 ^ value >> 63) as u64);
}

fn binary(bytes: &mut Vec<u8>, text: &str) {
    varint(bytes, text.len() as u64);
    bytes.extend_from_slice(text.as_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_the_protocol_says() {
        let mut bytes = Vec::new();
        // examples of the specification: 0, -1, 1, -2 become 0, 1, 2, 3; 50399 becomes DF 89 03
        [0, -1, 1, -2].into_iter().for_each(|value| zigzag(&mut bytes, value));
        varint(&mut bytes, 50399);
        assert_eq!(bytes, [0, 1, 2, 3, 0xdf, 0x89, 0x03]);
    }

    #[test]
    fn a_file_of_two_columns_holds_its_numbers_between_the_magic_words() {
        let columns =
            Columns { names: vec!["t".into(), "x".into()], rows: vec![vec![0.5, 2.0], vec![1.0, 3.0]] };
        let file = encode(&columns);
        assert!(file.starts_with(MAGIC) && file.ends_with(MAGIC));
        for column in [[0.5_f64, 1.0], [2.0, 3.0]] {
            let plain: Vec<u8> = column.iter().flat_map(|x| x.to_le_bytes()).collect();
            assert_eq!(file.windows(16).filter(|window| *window == plain).count(), 1);
        }
        let length = u32::from_le_bytes(file[file.len() - 8..file.len() - 4].try_into().unwrap()) as usize;
        assert_eq!(file[file.len() - 9], 0, "the footer ends with a stop");
        assert!(length < file.len());
    }
}
