//! Constants: finite binary floating-point numbers, compared by their bits.

/// A constant of an expression.
///
/// A binary floating-point number is an exact dyadic rational, so a constant is exact. `-0.0` is stored as `0.0`,
/// so that equal numbers have equal bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Constant(u64);

impl Constant {
    /// The constant 0.
    pub const ZERO: Self = Self(0);
    /// The constant 1.
    pub const ONE: Self = Self(1.0_f64.to_bits());

    /// The constant with the given value.
    pub const fn new(value: f64) -> Self {
        if value == 0.0 { Self::ZERO } else { Self(value.to_bits()) }
    }

    /// The value.
    pub const fn value(self) -> f64 {
        f64::from_bits(self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_of_both_signs_are_one_constant() {
        assert_eq!(Constant::new(-0.0), Constant::ZERO);
        assert_eq!(Constant::new(1.0), Constant::ONE);
        assert_ne!(Constant::new(-1.0), Constant::ONE);
    }
}
