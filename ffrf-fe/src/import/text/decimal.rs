//! Decimal digits and a power of ten to the nearest double.

/// Powers of ten that are exact in double precision. Static: a constant is copied wherever it is indexed.
static EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// Fifteen digits are exact as a double. So are some numbers of sixteen, but that these take one way and those
/// another could not be foreseen by the processor.
const EXACT_DIGITS: u64 = 1_000_000_000_000_000;

/// Smallest and largest power of ten of [`FIVES`]: 5^54 and 5^55 are the last that the loops below hold.
const SMALLEST: i32 = -54;
const LARGEST: i32 = 55;

/// The leading 128 bits of 5^q for q from [`SMALLEST`] to [`LARGEST`].
static FIVES: [u128; (LARGEST - SMALLEST + 1) as usize] = fives();

/// `mantissa` * 10^`power`, correctly rounded; `None` where the table of powers ends.
///
/// One exact multiplication or division of exact numbers rounds correctly (Clinger, "How to read floating point
/// numbers accurately", 1990). The rest takes the leading bits of `mantissa` * 5^`power` from a table (Lemire,
/// "Number parsing at a gigabyte per second", 2021); that these bits always decide the rounding is shown by
/// Mushtak and Lemire, "Fast number parsing without fallback", 2023.
#[inline(always)]
pub(crate) fn nearest(mantissa: u64, power: i32) -> Option<f64> {
    if mantissa < EXACT_DIGITS && power.unsigned_abs() <= 22 {
        let exact = EXACT_POWERS[power.unsigned_abs() as usize];
        return Some(if power < 0 { mantissa as i64 as f64 / exact } else { mantissa as i64 as f64 * exact });
    }
    leading_bits(mantissa, power)
}

#[inline(always)]
fn leading_bits(mantissa: u64, power: i32) -> Option<f64> {
    if mantissa == 0 {
        return Some(0.0);
    }
    let five = *FIVES.get(usize::try_from(power.wrapping_sub(SMALLEST)).ok()?)?;
    let zeros = mantissa.leading_zeros();
    let mantissa = u128::from(mantissa << zeros);
    let mut product = mantissa * (five >> 64);
    // 55 bits decide: 53, one to round and one for the leading zero. All ones below them may hide a carry.
    if (product >> 64) as u64 & 0x1ff == 0x1ff {
        product = product.wrapping_add((mantissa * (five & u128::from(u64::MAX))) >> 64);
    }
    let (high, low) = ((product >> 64) as u64, product as u64);
    let carried = (high >> 63) as i32;
    let shift = carried + 9;
    let mut bits = high >> shift;
    // floor(log2(10^power)) as a fixed-point product; 1023 is the bias of the exponent.
    let mut exponent = ((217_706 * power) >> 16) + 63 + carried - zeros as i32 + 1023;
    // Exactly half-way between two doubles: only for powers whose 5^|power| fits into 64 bits.
    if low <= 1 && (-4..=23).contains(&power) && bits & 3 == 1 && bits << shift == high {
        bits &= !1;
    }
    bits += bits & 1;
    bits >>= 1;
    if bits == 1 << 53 {
        bits >>= 1;
        exponent += 1;
    }
    // Between 1e-54 and 2e74 every number is a normal one.
    Some(f64::from_bits((bits & !(1 << 52)) | (exponent as u64) << 52))
}

const fn fives() -> [u128; (LARGEST - SMALLEST + 1) as usize] {
    let mut table = [0; (LARGEST - SMALLEST + 1) as usize];
    let mut five = 1_u128;
    let mut power = 0;
    while power <= LARGEST {
        table[(power - SMALLEST) as usize] = five << five.leading_zeros();
        if power > 0 && -power >= SMALLEST {
            table[(-power - SMALLEST) as usize] = reciprocal(five, power);
        }
        if power < LARGEST {
            five *= 5;
        }
        power += 1;
    }
    table
}

/// The leading 128 bits of 1 / `five`, where `five` = 5^`power`, by long division; rounded up as long as that product
/// with 64 bits is still exact enough (`power` up to 27), cut off beyond.
const fn reciprocal(five: u128, power: i32) -> u128 {
    let mut remainder = 1_u128;
    let mut quotient = 0_u128;
    while quotient >> 127 == 0 {
        remainder <<= 1;
        quotient <<= 1;
        if remainder >= five {
            remainder -= five;
            quotient |= 1;
        }
    }
    if power <= 27 { quotient + 1 } else { quotient }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn expected(mantissa: u64, power: i32) -> f64 {
        format!("{mantissa}e{power}").parse().unwrap()
    }

    #[test]
    fn the_table_holds_the_published_bits() {
        let five = |power: i32| FIVES[(power - SMALLEST) as usize];
        assert_eq!(five(0), 1 << 127);
        assert_eq!(five(1), 0xa000_0000_0000_0000_0000_0000_0000_0000);
        assert_eq!(five(-1), 0xcccc_cccc_cccc_cccc_cccc_cccc_cccc_cccd);
        assert_eq!(five(-2), 0xa3d7_0a3d_70a3_d70a_3d70_a3d7_0a3d_70a4);
        assert_eq!(five(55) >> 64, 0xd0cf_4b50_cfe2_0765);
    }

    #[test]
    fn halves_between_doubles_go_to_the_even_one() {
        // 2^53 + 1 and + 3 lie half-way; so do their multiples by powers of ten that stay exact in 64 bits.
        for odd in [1_u64, 3, 5, 7, 9_007_199_254_740_991] {
            let mantissa = (1 << 53) + odd;
            for power in -30..=30 {
                let value = nearest(mantissa, power).unwrap();
                assert_eq!(value.to_bits(), expected(mantissa, power).to_bits(), "{mantissa}e{power}");
            }
        }
        for power in 1..=23_u32 {
            let Some(scale) = 10_u64.checked_pow(power) else { break };
            for step in [1_u64, 3, 5] {
                // A half-way number with zeros behind the decimal point.
                let Some(mantissa) = ((1_u64 << 53) + step).checked_mul(scale) else { continue };
                let value = nearest(mantissa, -(power as i32)).unwrap();
                assert_eq!(value.to_bits(), expected(mantissa, -(power as i32)).to_bits());
            }
        }
    }

    #[test]
    fn what_the_table_does_not_reach_is_left_to_others() {
        assert_eq!(nearest(u64::MAX, LARGEST + 1), None);
        assert_eq!(nearest(u64::MAX, SMALLEST - 1), None);
        assert_eq!(nearest(0, 40), Some(0.0));
        assert_eq!(nearest(u64::MAX, i32::MAX), None);
        assert_eq!(nearest(u64::MAX, i32::MIN), None);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]
        #[test]
        fn agrees_with_the_standard_library(
            mantissa in any::<u64>(),
            cut in 0_u32..64,
            power in SMALLEST..=LARGEST,
        ) {
            let mantissa = mantissa >> cut;
            let value = nearest(mantissa, power).unwrap();
            prop_assert_eq!(value.to_bits(), expected(mantissa, power).to_bits());
        }

        #[test]
        fn agrees_beside_the_middle_of_two_doubles(
            fraction in 0_u64..1 << 52,
            exponent in 923_u64..1123,
            step in -2_i64..=2,
        ) {
            // The middle between a double and its neighbour, to 19 digits, and the decimals beside it.
            let value = f64::from_bits(exponent << 52 | fraction);
            let text = format!("{:.18e}", value + 0.5 * (value.next_up() - value));
            let (digits, power) = text.split_once('e').unwrap();
            let digits: u64 = digits.replace('.', "").parse().unwrap();
            let mantissa = digits.saturating_add_signed(step);
            let power: i32 = power.parse::<i32>().unwrap() - 18;
            prop_assert_eq!(nearest(mantissa, power).unwrap().to_bits(), expected(mantissa, power).to_bits());
        }
    }
}
