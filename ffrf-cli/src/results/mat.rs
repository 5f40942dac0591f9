//! MATLAB's files of level 5, uncompressed: matrices of doubles, and cells of texts.
//!
//! Source: MathWorks, MAT-File Format (2019), "Level 5 MAT-File Format".

use super::Array;

/// Data types and array classes.
const INT8: u32 = 1;
const UINT16: u32 = 4;
const INT32: u32 = 5;
const UINT32: u32 = 6;
const DOUBLE: u32 = 9;
const MATRIX: u32 = 14;
const CELL_CLASS: u32 = 1;
const CHAR_CLASS: u32 = 4;
const DOUBLE_CLASS: u32 = 6;

/// The bytes of a file of named arrays; an array of one axis becomes a column. No time of day goes in.
pub fn mat(arrays: impl IntoIterator<Item = (String, Array)>) -> Vec<u8> {
    let mut file = format!("{:<116}", "MATLAB 5.0 MAT-file, written by ffrf").into_bytes();
    file.extend_from_slice(&[0; 8]);
    // version, and the order of bytes as its reader sees it
    file.extend_from_slice(&[0x00, 0x01]);
    file.extend_from_slice(b"IM");
    for (name, array) in arrays {
        let body = match &array {
            Array::Numbers { shape, values } => numbers(&name, shape, values),
            Array::Texts(texts) => {
                let mut body = head(CELL_CLASS, &[texts.len(), 1], &name);
                for text in texts {
                    let units: Vec<u16> = text.encode_utf16().collect();
                    let mut cell = head(CHAR_CLASS, &[1, units.len()], "");
                    element(&mut cell, UINT16, units.iter().flat_map(|unit| unit.to_le_bytes()).collect());
                    element(&mut body, MATRIX, cell);
                }
                body
            }
        };
        element(&mut file, MATRIX, body);
    }
    file
}

fn numbers(name: &str, shape: &[usize], values: &[f64]) -> Vec<u8> {
    let (rows, columns) = match shape {
        [rows] => (*rows, 1),
        [rows, rest @ ..] => (*rows, rest.iter().product()),
        [] => (1, 1),
    };
    let mut body = head(DOUBLE_CLASS, &[rows, columns], name);
    // column by column; values stand row by row
    let places = (0..columns).flat_map(|column| (0..rows).map(move |row| row * columns + column));
    let ordered = places.map(|place| values.get(place).copied().unwrap_or(f64::NAN));
    element(&mut body, DOUBLE, ordered.flat_map(f64::to_le_bytes).collect());
    body
}

/// Flags, lengths and name of an array.
fn head(class: u32, shape: &[usize], name: &str) -> Vec<u8> {
    let mut body = Vec::new();
    element(&mut body, UINT32, [class, 0].into_iter().flat_map(u32::to_le_bytes).collect());
    let lengths = shape.iter().flat_map(|length| (*length as i32).to_le_bytes());
    element(&mut body, INT32, lengths.collect());
    element(&mut body, INT8, name.as_bytes().to_vec());
    body
}

/// A tagged element, filled up to a multiple of eight bytes.
fn element(file: &mut Vec<u8>, kind: u32, data: Vec<u8>) {
    file.extend_from_slice(&kind.to_le_bytes());
    file.extend_from_slice(&(data.len() as u32).to_le_bytes());
    let filling = data.len().next_multiple_of(8) - data.len();
    file.extend(data);
    file.extend(std::iter::repeat_n(0, filling));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_is_written_column_by_column_in_aligned_elements() {
        let array = Array::Numbers { shape: vec![2, 2], values: vec![1.0, 2.0, 3.0, 4.0] };
        let file = mat([("A".to_owned(), array)]);
        assert_eq!(file.len() % 8, 0);
        assert_eq!(&file[126..128], b"IM");
        let numbers: Vec<f64> = file[file.len() - 32..]
            .chunks_exact(8)
            .map(|x| f64::from_le_bytes(x.try_into().unwrap()))
            .collect();
        assert_eq!(numbers, [1.0, 3.0, 2.0, 4.0]);
    }
}
