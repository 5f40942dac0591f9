//! Comma-separated text.

use std::fmt::Write as _;

use super::Columns;

/// A line of names, then a line for each row; 17 significant digits bring every number back to its last bit.
pub(super) fn encode(columns: &Columns) -> Vec<u8> {
    let mut text = columns.names.join(",");
    text.push('\n');
    for row in &columns.rows {
        for (index, value) in row.iter().enumerate() {
            if index > 0 {
                text.push(',');
            }
            // writing to a String does not fail
            let _ = write!(text, "{value:.16e}");
        }
        text.push('\n');
    }
    text.into_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_to_their_last_bit() {
        let values = [0.1 + 0.2, -1e-308, f64::MAX, 0.0];
        let columns =
            Columns { names: vec!["a".into(), "b".into()], rows: values.map(|x| vec![x, -x]).to_vec() };
        let text = String::from_utf8(encode(&columns)).unwrap();
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some("a,b"));
        for (line, value) in lines.zip(values) {
            let (a, b) = line.split_once(',').unwrap();
            assert_eq!(a.parse(), Ok(value));
            assert_eq!(b.parse(), Ok(-value));
        }
    }
}
