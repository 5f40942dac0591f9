//! Every tolerance of these tests, with its reason. Polynomials and rational numbers need none.

/// Accelerations and their derivatives through a mass matrix with a condition number below 1e3, entries of order
/// one to a hundred: some thousand roundings.
pub const SOLVED: f64 = 1e-11;
