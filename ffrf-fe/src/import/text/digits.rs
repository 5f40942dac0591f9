//! Decimal digits, up to eight at a time in one machine word (Lemire, "Number parsing at a gigabyte per second",
//! 2021).

/// 10^n for the digits of one word.
pub(crate) static POWERS: [u64; 9] = [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

const ONES: u64 = 0x0101_0101_0101_0101;

/// Value and number of the digits at the start of `word`, whose first character is the lowest byte; `None` if all
/// eight are digits.
#[inline(always)]
pub(crate) fn leading(word: u64) -> Option<(u64, usize)> {
    // A digit becomes 0 to 9; the sum below sets the high bit of every byte above 9, without a carry between bytes.
    let nibbles = word ^ (0x30 * ONES);
    let others = (((nibbles & (0x7f * ONES)) + 0x76 * ONES) | nibbles) & (0x80 * ONES);
    if others == 0 {
        return None;
    }
    // The lowest bit that is set is the high bit of the first other byte.
    let bits = others.trailing_zeros() & 0x38;
    // Moves the digits to the high bytes; the bytes below become leading zeros.
    let aligned = (nibbles << 8) << (56 - bits);
    Some((combine(aligned), (bits / 8) as usize))
}

/// Value of a word of eight digits.
#[inline(always)]
pub(crate) fn eight(word: u64) -> u64 {
    combine(word ^ (0x30 * ONES))
}

/// Value of eight digits 0 to 9, the most significant in the lowest byte.
#[inline(always)]
fn combine(digits: u64) -> u64 {
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8);
    let even = (pairs & 0x0000_00ff_0000_00ff).wrapping_mul(0x000f_4240_0000_0064);
    let odd = ((pairs >> 16) & 0x0000_00ff_0000_00ff).wrapping_mul(0x0000_2710_0000_0001);
    even.wrapping_add(odd) >> 32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &[u8; 8]) -> Option<(u64, usize)> {
        leading(u64::from_le_bytes(*text))
    }

    #[test]
    fn digits_end_where_the_first_other_byte_stands() {
        for text in [b"12345678", b"00000009", b"99999999"] {
            assert_eq!(read(text), None);
            let value: u64 = std::str::from_utf8(text).unwrap().parse().unwrap();
            assert_eq!(eight(u64::from_le_bytes(*text)), value);
        }
        for byte in (0..=u8::MAX).filter(|byte| !byte.is_ascii_digit()) {
            for place in 0..8 {
                let mut text = *b"98765432";
                text[place] = byte;
                let value = std::str::from_utf8(&text[..place]).unwrap().parse().unwrap_or(0);
                assert_eq!(read(&text), Some((value, place)), "{text:?}");
            }
        }
    }
}
