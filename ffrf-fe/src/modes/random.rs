//! A fixed sequence of numbers that are not special: start vectors must be reproducible and not symmetric.

/// SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014) from a fixed seed.
pub(crate) struct Random {
    state: u64,
}

impl Random {
    pub fn new() -> Self {
        Self { state: 0x005E_ED0F_F12F }
    }

    /// Numbers in [-1, 1).
    pub fn fill(&mut self, values: &mut [f64]) {
        for value in values {
            self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut bits = self.state;
            bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            bits ^= bits >> 31;
            // 53 bits to [0, 2), exactly.
            *value = (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0;
        }
    }
}
