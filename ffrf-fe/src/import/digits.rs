//! Decimal digits, up to eight at a time in one machine word (Lemire, "Number parsing at a gigabyte per second",
//! 2021).

/// 10^n for the digits of one word.
const POWERS: [u64; 9] = [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

const ONES: u64 = 0x0101_0101_0101_0101;

/// Appends the digits at the start of `word`, first character in the lowest byte, to `value`; returns the new value
/// and how many digits there were. Beyond 19 digits the value wraps.
#[inline(always)]
pub(crate) fn append(word: u64, value: u64) -> (u64, usize) {
    // A digit becomes 0 to 9; the sum below sets the high bit of every byte above 9, without a carry between bytes.
    let nibbles = word ^ (0x30 * ONES);
    let others = (((nibbles & (0x7f * ONES)) + 0x76 * ONES) | nibbles) & (0x80 * ONES);
    if others == 0 {
        return (value.wrapping_mul(POWERS[8]).wrapping_add(combine(nibbles)), 8);
    }
    let count = (others.trailing_zeros() / 8) as usize;
    // Moves the digits to the high bytes; the bytes below become leading zeros.
    let aligned = (nibbles << 8) << (56 - 8 * count);
    (value.wrapping_mul(POWERS[count]).wrapping_add(combine(aligned)), count)
}

/// Value of eight digits 0 to 9, the most significant in the lowest byte.
#[inline]
fn combine(digits: u64) -> u64 {
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8);
    let even = (pairs & 0x0000_00ff_0000_00ff).wrapping_mul(0x000f_4240_0000_0064);
    let odd = ((pairs >> 16) & 0x0000_00ff_0000_00ff).wrapping_mul(0x0000_2710_0000_0001);
    even.wrapping_add(odd) >> 32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &[u8; 8]) -> (usize, u64) {
        let (value, count) = append(u64::from_le_bytes(*text), 0);
        (count, value)
    }

    #[test]
    fn digits_end_where_the_first_other_byte_stands() {
        assert_eq!(read(b"12345678"), (8, 12_345_678));
        assert_eq!(read(b"00000009"), (8, 9));
        assert_eq!(read(b"99999999"), (8, 99_999_999));
        for byte in (0..=u8::MAX).filter(|byte| !byte.is_ascii_digit()) {
            for place in 0..8 {
                let mut text = *b"98765432";
                text[place] = byte;
                let value = std::str::from_utf8(&text[..place]).unwrap().parse().unwrap_or(0);
                assert_eq!(read(&text), (place, value), "{text:?}");
            }
        }
    }

    #[test]
    fn digits_are_appended() {
        assert_eq!(append(u64::from_le_bytes(*b"034 5678"), 12), (12_034, 3));
        assert_eq!(append(u64::from_le_bytes(*b"12345678"), 9), (912_345_678, 8));
    }
}
