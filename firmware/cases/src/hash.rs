//! A hash of the bits of numbers.

use ffrf::nalgebra::RealField;

/// A scalar with its bits.
pub trait Bits: RealField + Copy {
    /// Sign, exponent and fraction.
    fn bits(self) -> u64;
}

impl Bits for f32 {
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
}

impl Bits for f64 {
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

/// FNV-1a over words in place of bytes: cheap on a microcontroller, and any bit that differs changes it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hash(pub u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    /// Takes the numbers in.
    pub fn numbers<T: Bits>(&mut self, numbers: &[T]) {
        for number in numbers {
            self.word(number.bits());
        }
    }

    /// Takes a word in. The rotation lets high bits reach low ones, which a product alone never does.
    pub fn word(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01b3).rotate_left(23);
    }
}
