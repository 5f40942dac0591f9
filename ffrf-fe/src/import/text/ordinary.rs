//! The tokens of an ordinary line, read without looking back: each function returns what it read and the offset
//! behind it, or `None` for whatever is not ordinary, which [`super::cursor::Cursor`] then reads or refuses.
//!
//! Floats are read by `fast-float2`. A parser of our own, with up to eight digits in a machine word, took 429 instead of
//! 517 instructions a line of a matrix (15 decimals; 392 instead of 493 with 13), about 20 ms less in a million entries
//! whose modes then take seconds: not worth 300 lines.

/// An index of one to nine digits, and the offset behind the blanks or the comma after it.
#[inline(always)]
pub(crate) fn index(bytes: &[u8], at: usize) -> Option<(u32, usize)> {
    let (value, end) = digits(bytes, at);
    if end == at || end - at > 9 || !is_separator(*bytes.get(end)?) {
        return None;
    }
    // Nine digits fit.
    Some((value as u32, token(bytes, end + 1)?))
}

/// The offset of the next token behind blanks and commas.
#[inline(always)]
pub(crate) fn token(bytes: &[u8], mut at: usize) -> Option<usize> {
    while is_separator(*bytes.get(at)?) {
        at += 1;
    }
    Some(at)
}

/// The last token of a line, a finite number, and the offset of the next line.
#[inline(always)]
pub(crate) fn last_float(bytes: &[u8], at: usize) -> Option<(f64, usize)> {
    let (value, at) = float(bytes, at)?;
    match bytes.get(at)? {
        b'\n' => Some((value, at + 1)),
        b'\r' if bytes.get(at + 1) == Some(&b'\n') => Some((value, at + 2)),
        _ => None,
    }
}

/// A finite number, correctly rounded, and the offset behind it.
#[inline(always)]
pub(crate) fn float(bytes: &[u8], start: usize) -> Option<(f64, usize)> {
    let (value, length) = fast_float2::parse_partial::<f64, _>(bytes.get(start..)?).ok()?;
    value.is_finite().then_some((value, start + length))
}

#[inline(always)]
fn is_separator(byte: u8) -> bool {
    matches!(byte, b' ' | b',' | b'\t')
}

/// The value of the decimal digits from `start` on, modulo 2^64, and the offset behind them.
#[inline(always)]
pub(crate) fn digits(bytes: &[u8], start: usize) -> (u64, usize) {
    let (mut value, mut at) = (0_u64, start);
    while let Some(byte @ b'0'..=b'9') = bytes.get(at) {
        value = value.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
        at += 1;
    }
    (value, at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ordinary_line_is_read_token_by_token() {
        let line = b"1204,3, \t 17 -7.78648293016e+08\r\n1";
        assert_eq!(index(line, 0), Some((1204, 5)));
        assert_eq!(index(line, 5), Some((3, 10)));
        assert_eq!(index(line, 10), Some((17, 13)));
        assert_eq!(last_float(line, 13), Some((-7.78648293016e8, line.len() - 1)));
    }

    #[test]
    fn what_is_not_ordinary_is_left_to_the_cursor() {
        for text in [
            "",
            "7",
            "1234567",
            "1234567890 1.0",
            " 7 1.0000",
            "x 1.00000",
            "7\n1 1 1.0",
            "7.5 1 1.0",
            "-7 1 1.00",
        ] {
            assert_eq!(index(text.as_bytes(), 0), None, "{text:?}");
        }
        for text in [
            "",
            "1.0",
            "1.0 \n",
            "1.0 5\n",
            "1.0x\n",
            "nan\n",
            "inf\n",
            "1.0\r",
            "1.0e\n",
            "e5\n",
            ".\n",
            "1e99999\n",
            "1e400\n",
        ] {
            assert_eq!(last_float(text.as_bytes(), 0), None, "{text:?}");
        }
    }
}
