//! The tokens of an ordinary line, read without looking back: each function returns what it read and the offset
//! behind it, or `None` for whatever is not ordinary, which [`super::cursor::Cursor`] then reads or refuses.

use super::{decimal, digits};

/// An index of one to seven digits, and the offset behind the blanks or the comma after it.
#[inline(always)]
pub(crate) fn index(bytes: &[u8], at: usize) -> Option<(u32, usize)> {
    let (value, count) = digits::leading(word(bytes, at)?)?;
    let at = at + count;
    if count == 0 || !is_separator(*bytes.get(at)?) {
        return None;
    }
    // Seven digits fit.
    Some((value as u32, token(bytes, at + 1)?))
}

/// The offset of the next token behind blanks and commas.
#[inline(always)]
pub(crate) fn token(bytes: &[u8], mut at: usize) -> Option<usize> {
    while is_separator(*bytes.get(at)?) {
        at += 1;
    }
    Some(at)
}

/// The last token of a line, a number of up to 19 digits in reach of [`decimal::nearest`], and the offset of the next
/// line.
#[inline(always)]
pub(crate) fn last_float(bytes: &[u8], at: usize) -> Option<(f64, usize)> {
    let (value, at) = float(bytes, at)?;
    match bytes.get(at)? {
        b'\n' => Some((value, at + 1)),
        b'\r' if bytes.get(at + 1) == Some(&b'\n') => Some((value, at + 2)),
        _ => None,
    }
}

/// A number of up to 19 digits in reach of [`decimal::nearest`], and the offset behind it.
#[inline(always)]
pub(crate) fn float(bytes: &[u8], start: usize) -> Option<(f64, usize)> {
    let (negative, start) = sign(bytes, start)?;
    let (mut mantissa, mut at) = match bytes.get(start..)?.first_chunk() {
        // The usual `d.ddd`
        Some(&[digit @ b'0'..=b'9', b'.']) => (u64::from(digit - b'0'), start + 1),
        _ => digits(bytes, start, 0),
    };
    let mut count = at - start;
    let mut exponent = 0;
    if bytes.get(at) == Some(&b'.') {
        let point = at + 1;
        (mantissa, at) = digits(bytes, point, mantissa);
        count += at - point;
        exponent = -((at - point) as i32);
    }
    if count == 0 || count > 19 {
        return None;
    }
    if let Some(b'e' | b'E' | b'd' | b'D') = bytes.get(at) {
        let (down, start) = sign(bytes, at + 1)?;
        let mut power = 0;
        at = start;
        while let Some(digit @ b'0'..=b'9') = bytes.get(at) {
            power = 10 * power + i32::from(digit - b'0');
            at += 1;
            if at - start > 4 {
                return None;
            }
        }
        if at == start {
            return None;
        }
        exponent += if down { -power } else { power };
    }
    let magnitude = decimal::nearest(mantissa, exponent)?;
    Some((f64::from_bits(magnitude.to_bits() | u64::from(negative) << 63), at))
}

#[inline(always)]
fn is_separator(byte: u8) -> bool {
    matches!(byte, b' ' | b',' | b'\t')
}

/// Eight bytes, the first one lowest; `None` near the end of the file.
#[inline(always)]
fn word(bytes: &[u8], at: usize) -> Option<u64> {
    bytes.get(at..)?.first_chunk().map(|word| u64::from_le_bytes(*word))
}

/// True for a minus, and the offset behind the sign. Without branches, because signs follow no pattern.
#[inline(always)]
fn sign(bytes: &[u8], at: usize) -> Option<(bool, usize)> {
    let byte = *bytes.get(at)?;
    Some((byte == b'-', at + usize::from(byte == b'-' || byte == b'+')))
}

/// Appends decimal digits to `value`; returns the new value and the offset behind the digits.
#[inline(always)]
pub(crate) fn digits(bytes: &[u8], start: usize, mut value: u64) -> (u64, usize) {
    let mut at = start;
    while let Some(word) = word(bytes, at) {
        match digits::leading(word) {
            None => {
                value = value.wrapping_mul(digits::POWERS[8]).wrapping_add(digits::eight(word));
                at += 8;
            }
            Some((more, count)) => {
                return (value.wrapping_mul(digits::POWERS[count]).wrapping_add(more), at + count);
            }
        }
    }
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
            "12345678 1.0",
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
