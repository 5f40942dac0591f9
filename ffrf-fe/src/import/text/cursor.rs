//! Numbers in bytes: a cursor that reads integers and floats without allocating.

use super::ordinary;

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

    /// The rest of the token that starts here.
    fn token(&self) -> &'a [u8] {
        let mut end = self.at;
        while !is_token_end(self.bytes.get(end)) {
            end += 1;
        }
        &self.bytes[self.at..end]
    }

    fn defect<T>(&self, kind: DefectKind) -> Result<T, Defect> {
        Err(Defect { at: self.at, kind })
    }

    /// Reads the next token as a non-negative integer.
    pub(crate) fn unsigned(&mut self, expected: &'static str) -> Result<u64, Defect> {
        self.skip_separators();
        let (value, end) = ordinary::digits(self.bytes, self.at);
        let count = end - self.at;
        if count == 0 || count > 19 || !is_token_end(self.bytes.get(end)) {
            return self.defect(DefectKind::Expected(expected));
        }
        self.at = end;
        Ok(value)
    }

    /// Reads the next token as a finite float, correctly rounded.
    ///
    /// Numbers with the exponent letter of Fortran, `d`, go through the standard library.
    #[inline]
    pub(crate) fn float(&mut self, expected: &'static str) -> Result<f64, Defect> {
        self.skip_separators();
        match ordinary::float(self.bytes, self.at) {
            Some((value, end)) if is_token_end(self.bytes.get(end)) => {
                self.at = end;
                Ok(value)
            }
            _ => self.long_float(expected),
        }
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

#[inline]
fn is_token_end(byte: Option<&u8>) -> bool {
    matches!(byte, None | Some(b'\n' | b' ' | b'\t' | b',' | b'\r'))
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
