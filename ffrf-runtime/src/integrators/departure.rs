//! What a state has left of what was planned for it.

/// Which bounds a state has left. A state that is not a number has left all that it touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Departure {
    /// The deformation is larger than planned.
    pub deformation: bool,
    /// The body moves faster than planned.
    pub speed: bool,
    /// The body turns faster than planned.
    pub spin: bool,
    /// The body turns faster than its first bending frequency.
    pub bending: bool,
}

impl Departure {
    /// Whether any bound was left.
    pub fn any(self) -> bool {
        self.deformation || self.speed || self.spin || self.bending
    }

    /// What either has left.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self {
            deformation: self.deformation || other.deformation,
            speed: self.speed || other.speed,
            spin: self.spin || other.spin,
            bending: self.bending || other.bending,
        }
    }
}
