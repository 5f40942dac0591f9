//! Numbers in bytes: a cursor that reads integers and floats without allocating.

/// What is wrong at a place of a file; turned into an error with the line number by [`super::source::Source`].
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Defect {
    /// Byte offset of the offending token.
    pub(crate) at: usize,
    /// What is wrong there.
    pub(crate) kind: DefectKind,
}

/// Kinds of defect that a scan can meet.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum DefectKind {
    /// The token is not what the format asks for.
    Expected(&'static str),
    /// The token must be a number in this range.
    ExpectedIndex(usize),
    /// The token is a number, but not a finite one.
    NonFinite,
    /// The token is the id of no known node.
    UnknownNode(u64),
}

/// Powers of ten that are exact in double precision.
const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// A position in a byte buffer.
#[derive(Debug, Clone)]
pub(crate) struct Cursor<'a> {
    bytes: &'a [u8],
    /// Offset of the next byte.
    pub(crate) at: usize,
}

impl<'a> Cursor<'a> {
    pub(crate) fn new(bytes: &'a [u8], at: usize) -> Self {
        Cursor { bytes, at }
    }

    #[inline]
    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    /// True at the end of the line or of the file.
    #[inline]
    pub(crate) fn at_line_end(&self) -> bool {
        matches!(self.peek(), None | Some(b'\n'))
    }

    /// Skips blanks, tabs, carriage returns and commas.
    #[inline]
    pub(crate) fn skip_separators(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b',' | b'\r')) {
            self.at += 1;
        }
    }

    /// Goes to the start of the next line.
    pub(crate) fn next_line(&mut self) {
        while let Some(byte) = self.peek() {
            self.at += 1;
            if byte == b'\n' {
                break;
            }
        }
    }

    #[inline]
    fn at_token_end(&self) -> bool {
        matches!(self.peek(), None | Some(b'\n' | b' ' | b'\t' | b',' | b'\r'))
    }

    /// The rest of the token that starts here.
    fn token(&self) -> &'a [u8] {
        let mut probe = self.clone();
        while !probe.at_token_end() {
            probe.at += 1;
        }
        &self.bytes[self.at..probe.at]
    }

    fn defect<T>(&self, kind: DefectKind) -> Result<T, Defect> {
        Err(Defect { at: self.at, kind })
    }

    /// Reads the next token as a non-negative integer.
    #[inline]
    pub(crate) fn unsigned(&mut self, expected: &'static str) -> Result<u64, Defect> {
        self.skip_separators();
        let start = self.at;
        let mut value = 0_u64;
        while let Some(byte @ b'0'..=b'9') = self.peek() {
            value = value.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
            self.at += 1;
        }
        let digits = self.at - start;
        if digits == 0 || digits > 19 || !self.at_token_end() {
            self.at = start;
            return self.defect(DefectKind::Expected(expected));
        }
        Ok(value)
    }

    /// Reads the next token as a finite float, correctly rounded.
    ///
    /// Up to 2^53 in the digits and 10^22 in the exponent one exact multiplication or division rounds correctly
    /// (Clinger, "How to read floating point numbers accurately", 1990); the rest goes through the standard
    /// library.
    #[inline]
    pub(crate) fn float(&mut self, expected: &'static str) -> Result<f64, Defect> {
        self.skip_separators();
        let start = self.at;
        match self.short_float() {
            Some(value) if self.at_token_end() => Ok(value),
            _ => {
                self.at = start;
                self.long_float(expected)
            }
        }
    }

    #[inline]
    fn short_float(&mut self) -> Option<f64> {
        let negative = self.sign();
        let mut mantissa = 0_u64;
        let whole = self.digits(&mut mantissa);
        let mut exponent = 0_i64;
        let mut fraction = 0;
        if self.peek() == Some(b'.') {
            self.at += 1;
            fraction = self.digits(&mut mantissa);
            exponent = -i64::try_from(fraction).ok()?;
        }
        if whole + fraction == 0 || whole + fraction > 19 {
            return None;
        }
        if let Some(b'e' | b'E' | b'd' | b'D') = self.peek() {
            self.at += 1;
            let negative_exponent = self.sign();
            let mut power = 0_u64;
            let digits = self.digits(&mut power);
            if digits == 0 || digits > 4 {
                return None;
            }
            let power = i64::try_from(power).ok()?;
            exponent += if negative_exponent { -power } else { power };
        }
        if mantissa > 1 << 53 {
            return None;
        }
        let power = *EXACT_POWERS.get(usize::try_from(exponent.unsigned_abs()).ok()?)?;
        let magnitude = if exponent < 0 { mantissa as f64 / power } else { mantissa as f64 * power };
        Some(if negative { -magnitude } else { magnitude })
    }

    #[inline]
    fn sign(&mut self) -> bool {
        match self.peek() {
            Some(b'-') => {
                self.at += 1;
                true
            }
            Some(b'+') => {
                self.at += 1;
                false
            }
            _ => false,
        }
    }

    /// Appends decimal digits to `value` and returns how many there were.
    #[inline]
    fn digits(&mut self, value: &mut u64) -> usize {
        let start = self.at;
        while let Some(eight) = self.bytes.get(self.at..self.at + 8).and_then(eight_digits) {
            *value = value.wrapping_mul(100_000_000).wrapping_add(eight);
            self.at += 8;
        }
        while let Some(byte @ b'0'..=b'9') = self.peek() {
            *value = value.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
            self.at += 1;
        }
        self.at - start
    }

    #[cold]
    fn long_float(&mut self, expected: &'static str) -> Result<f64, Defect> {
        let token = self.token();
        let parsed = std::str::from_utf8(token)
            .ok()
            .and_then(|text| text.parse::<f64>().ok().or_else(|| text.replace(['d', 'D'], "e").parse().ok()));
        match parsed {
            Some(value) if value.is_finite() => {
                self.at += token.len();
                Ok(value)
            }
            Some(_) => self.defect(DefectKind::NonFinite),
            None => self.defect(DefectKind::Expected(expected)),
        }
    }

    /// Asserts that nothing but separators stands before the line end, and goes to the next line.
    #[inline]
    pub(crate) fn end_line(&mut self, expected: &'static str) -> Result<(), Defect> {
        self.skip_separators();
        if !self.at_line_end() {
            return self.defect(DefectKind::Expected(expected));
        }
        self.at += usize::from(self.at < self.bytes.len());
        Ok(())
    }
}

/// Value of eight decimal digits, if all eight bytes are digits; byte-parallel arithmetic in one word
/// (Lemire, "Number parsing at a gigabyte per second", 2021).
#[inline]
fn eight_digits(bytes: &[u8]) -> Option<u64> {
    let word = u64::from_le_bytes(bytes.try_into().ok()?);
    let high = word & 0xf0f0_f0f0_f0f0_f0f0;
    let carried = word.wrapping_add(0x0606_0606_0606_0606) & 0xf0f0_f0f0_f0f0_f0f0;
    if high | (carried >> 4) != 0x3333_3333_3333_3333 {
        return None;
    }
    let digits = word & 0x0f0f_0f0f_0f0f_0f0f;
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8);
    let even = (pairs & 0x0000_00ff_0000_00ff).wrapping_mul(0x000f_4240_0000_0064);
    let odd = ((pairs >> 16) & 0x0000_00ff_0000_00ff).wrapping_mul(0x0000_2710_0000_0001);
    Some(even.wrapping_add(odd) >> 32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn float(text: &str) -> Result<f64, Defect> {
        Cursor::new(text.as_bytes(), 0).float("a number")
    }

    #[test]
    fn reads_the_spellings_of_fe_codes() {
        for (text, value) in [
            ("4.", 4.0_f64),
            ("1.e-001", 0.1),
            ("-0.", -0.0),
            (".5", 0.5),
            ("+1.5E+02,", 150.0),
            ("1.0D-3\r\n", 1e-3),
            ("1e36", 1e36),
            ("4.9e-324", 5e-324),
            ("123456789012345678901234567890", 123456789012345678901234567890.0),
        ] {
            assert_eq!(float(text).map(f64::to_bits), Ok(value.to_bits()), "{text}");
        }
    }

    #[test]
    fn eight_digits_are_eight_digits() {
        assert_eq!(eight_digits(b"12345678"), Some(12_345_678));
        assert_eq!(eight_digits(b"00000009"), Some(9));
        assert_eq!(eight_digits(b"99999999"), Some(99_999_999));
        for byte in 0..=u8::MAX {
            for place in 0..8 {
                let mut text = *b"11111111";
                text[place] = byte;
                assert_eq!(eight_digits(&text).is_some(), byte.is_ascii_digit(), "{text:?}");
            }
        }
    }

    #[test]
    fn refuses_what_is_no_finite_number() {
        assert_eq!(float(" nan").unwrap_err(), Defect { at: 1, kind: DefectKind::NonFinite });
        assert_eq!(float("1e999").unwrap_err().kind, DefectKind::NonFinite);
        for text in ["", "-", "e5", "1.2.3", "1e", "0x10", "1;2", "\u{ff11}"] {
            assert_eq!(float(text).unwrap_err().kind, DefectKind::Expected("a number"), "{text}");
        }
        assert!(Cursor::new(b"-3", 0).unsigned("an index").is_err());
        assert!(Cursor::new(b"99999999999999999999", 0).unsigned("an index").is_err());
    }

    proptest! {
        #[test]
        fn agrees_with_the_standard_library(bits in any::<u64>(), digits in 0_usize..18) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite());
            for text in [format!("{value}"), format!("{value:e}"), format!("{value:.digits$e}")] {
                let expected: f64 = text.parse().unwrap();
                if expected.is_finite() {
                    prop_assert_eq!(float(&text).unwrap().to_bits(), expected.to_bits(), "{}", text);
                }
            }
        }
    }
}
