//! What cannot be written as an exact polynomial.

/// Why an expression has no exact polynomial.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PolynomialError {
    /// A sum or product of coefficients needs more than 127 significant bits; it is not rounded instead.
    #[error("a coefficient needs more than 127 bits")]
    CoefficientOverflow,
    /// A constant is infinite or not a number.
    #[error("{value} is not a finite constant")]
    NotFinite {
        /// The constant.
        value: f64,
    },
    /// The expression divides by something that is not a constant power of two.
    #[error("a quotient is not a polynomial")]
    Division,
    /// The expression takes a square root.
    #[error("a square root is not a polynomial")]
    SquareRoot,
}
