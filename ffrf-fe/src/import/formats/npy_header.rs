//! The header of a `.npy` array, looked over before a parser sees it: lengths that are announced and not there.

/// First bytes of a `.npy` file.
pub(super) const NPY_MAGIC: &[u8] = b"\x93NUMPY";
/// A header longer than this is no array of numbers. NumPy writes 118 bytes.
const LONGEST: usize = 1 << 16;
/// Brackets in each other that an array of numbers needs, with a margin.
const DEEPEST: usize = 4;
/// Values up to which an array is taken for one: row numbers are kept in 32 bits.
const MOST_VALUES: u64 = u32::MAX as u64;

/// What is wrong with a header.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct HeaderDefect {
    pub(super) expected: String,
    pub(super) found: String,
}

/// Refuses a header that announces more than there can be.
///
/// The parser behind it trusts lengths, multiplies shapes and follows nested brackets without limit.
pub(super) fn check(bytes: &[u8]) -> Result<(), HeaderDefect> {
    let defect = |expected: String, found: String| Err(HeaderDefect { expected, found });
    let (length, start) = match bytes.strip_prefix(NPY_MAGIC) {
        Some(&[1, _, a, b, ..]) => (usize::from(u16::from_le_bytes([a, b])), NPY_MAGIC.len() + 4),
        Some(&[_, _, a, b, c, d, ..]) => (u32::from_le_bytes([a, b, c, d]) as usize, NPY_MAGIC.len() + 6),
        _ => return defect("a NumPy header".to_owned(), format!("{} bytes", bytes.len())),
    };
    if length > LONGEST {
        return defect(format!("a header of at most {LONGEST} bytes"), format!("{length} bytes announced"));
    }
    let Some(header) = bytes.get(start..start + length) else {
        return defect(format!("a header of {length} bytes"), format!("{} bytes", bytes.len() - start));
    };
    let mut depth = 0_usize;
    let mut values = 1_u64;
    let mut number: Option<u64> = None;
    for &byte in header.iter().chain(b" ") {
        if byte.is_ascii_digit() {
            let digit = u64::from(byte - b'0');
            number = Some(number.unwrap_or(0).saturating_mul(10).saturating_add(digit));
            continue;
        }
        // Numbers in brackets are lengths of the shape; a length of 0 still takes part in the strides.
        if let Some(length) = number.take()
            && depth > 1
        {
            values = values.saturating_mul(length.max(1));
        }
        match byte {
            b'(' | b'[' | b'{' => depth += 1,
            b')' | b']' | b'}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > DEEPEST {
            return defect(format!("at most {DEEPEST} brackets in each other"), "more".to_owned());
        }
    }
    if values > MOST_VALUES {
        return defect(format!("at most {MOST_VALUES} values"), format!("{values} announced"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(text: &str) -> Vec<u8> {
        let length = (text.len() as u16).to_le_bytes();
        [NPY_MAGIC, &[1, 0], &length, text.as_bytes()].concat()
    }

    fn found(bytes: &[u8]) -> String {
        check(bytes).map_or_else(|defect| defect.found, |()| "nothing".to_owned())
    }

    #[test]
    fn what_is_announced_and_not_there_is_refused_with_its_number() {
        let shape =
            |shape: &str| header(&format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}"));
        assert_eq!(found(&shape("(33, 6)")), "nothing");
        assert_eq!(found(&shape("(33, 4000000000)")), "132000000000 announced");
        assert_eq!(
            found(&shape("(0, 18446744073709551615, 18446744073709551615)")),
            format!("{} announced", u64::MAX)
        );
        assert_eq!(found(&[NPY_MAGIC, &[2, 0, 255, 255, 255, 255]].concat()), "4294967295 bytes announced");
        assert_eq!(found(&header("{'shape': ((((((((((")), "more");
        let whole = shape("(33, 6)");
        assert_eq!(found(&whole[..20]), "10 bytes");
        assert_eq!(found(&whole[..7]), "7 bytes");
    }
}
