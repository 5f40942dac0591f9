//! Exact coefficients: dyadic rationals, mantissa times a power of two.

use std::fmt;

/// An exact number `mantissa * 2^exponent`, with an odd mantissa (or zero), so that equality is structural.
///
/// Every finite `f64` is such a number, and sums and products of such numbers are again. Division is
/// not offered: a polynomial does not need it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dyadic {
    mantissa: i128,
    exponent: i32,
}

impl Dyadic {
    /// 0.
    pub const ZERO: Self = Self { mantissa: 0, exponent: 0 };
    /// 1.
    pub const ONE: Self = Self { mantissa: 1, exponent: 0 };

    /// The exact value of `value`; `None` if it is infinite or not a number.
    pub fn from_f64(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        let bits = value.to_bits();
        let biased = ((bits >> 52) & 0x7ff) as i32;
        let fraction = i128::from(bits & ((1 << 52) - 1));
        // Subnormal numbers have no hidden bit and the exponent of the least normal ones (IEEE 754, 3.4).
        let (magnitude, exponent) =
            if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
        Some(Self::reduced(if value.is_sign_negative() { -magnitude } else { magnitude }, exponent))
    }

    fn reduced(mantissa: i128, exponent: i32) -> Self {
        if mantissa == 0 {
            return Self::ZERO;
        }
        let shift = mantissa.trailing_zeros();
        Self { mantissa: mantissa >> shift, exponent: exponent + shift as i32 }
    }

    /// Whether the number is 0.
    pub fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    /// The sum; `None` if it needs more than 127 bits.
    pub fn checked_add(self, other: Self) -> Option<Self> {
        if self.is_zero() {
            return Some(other);
        }
        if other.is_zero() {
            return Some(self);
        }
        let exponent = self.exponent.min(other.exponent);
        let sum = self.mantissa_at(exponent)?.checked_add(other.mantissa_at(exponent)?)?;
        Some(Self::reduced(sum, exponent))
    }

    /// The mantissa that goes with a smaller exponent.
    fn mantissa_at(self, exponent: i32) -> Option<i128> {
        let shift = u32::try_from(self.exponent - exponent).ok().filter(|shift| *shift < 127)?;
        self.mantissa.checked_mul(1_i128 << shift)
    }

    /// The product; `None` if it needs more than 127 bits.
    pub fn checked_mul(self, other: Self) -> Option<Self> {
        let mantissa = self.mantissa.checked_mul(other.mantissa)?;
        Some(Self::reduced(mantissa, self.exponent.checked_add(other.exponent)?))
    }

    /// The number with the opposite sign.
    #[must_use]
    pub fn negated(self) -> Self {
        Self { mantissa: -self.mantissa, exponent: self.exponent }
    }

    /// Whether the number is below 0.
    pub fn is_negative(self) -> bool {
        self.mantissa < 0
    }
}

impl fmt::Display for Dyadic {
    /// An integer, or a fraction with a power of two below: `-3/4`.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.exponent, u32::try_from(self.exponent)) {
            (-126..=-1, _) => {
                write!(formatter, "{}/{}", self.mantissa, 1_u128 << self.exponent.unsigned_abs())
            }
            (_, Ok(shift)) if shift < self.mantissa.unsigned_abs().leading_zeros() => {
                write!(formatter, "{}", self.mantissa << shift)
            }
            _ => write!(formatter, "{}*2^{}", self.mantissa, self.exponent),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dyadic(value: f64) -> Dyadic {
        Dyadic::from_f64(value).unwrap()
    }

    #[test]
    fn floats_are_taken_exactly() {
        // 0.1 is not a tenth: 0.1 + 0.2 is exact here and differs from the rounded 0.3.
        assert_ne!(dyadic(0.1).checked_add(dyadic(0.2)), Some(dyadic(0.3)));
        assert_eq!(dyadic(0.1).checked_add(dyadic(-0.1)), Some(Dyadic::ZERO));
        assert_eq!(dyadic(-0.0), Dyadic::ZERO);
        assert_eq!(
            dyadic(f64::from_bits(1)).checked_mul(dyadic(4.0)),
            Some(Dyadic { mantissa: 1, exponent: -1072 })
        );
        assert_eq!(Dyadic::from_f64(f64::NAN), None);
    }

    #[test]
    fn arithmetic_agrees_with_that_of_small_floats() {
        let values = [0.0, 1.0, -1.0, 0.5, -0.75, 3.0, 12.0, 1024.0, -0.001_953_125];
        for a in values {
            for b in values {
                assert_eq!(dyadic(a).checked_add(dyadic(b)), Some(dyadic(a + b)), "{a} + {b}");
                assert_eq!(dyadic(a).checked_mul(dyadic(b)), Some(dyadic(a * b)), "{a} * {b}");
            }
        }
    }

    #[test]
    fn overflow_is_reported() {
        let wide = dyadic(1.0e300).checked_add(dyadic(1.0e-300));
        assert_eq!(wide, None);
        let third = dyadic(1.0 / 3.0);
        let square = third.checked_mul(third).unwrap();
        assert_eq!(square.checked_mul(third), None);
    }

    #[test]
    fn display_is_readable() {
        let shown: Vec<String> =
            [0.0, 1.0, -0.75, 12.0, 0.5].map(|value| dyadic(value).to_string()).into_iter().collect();
        assert_eq!(shown, ["0", "1", "-3/4", "12", "1/2"]);
    }
}
