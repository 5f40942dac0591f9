//! Tolerances of these tests, each with its reason.

/// A static solution by the sparse factor against dense algebra: both lose the condition of K, about 1e6 for the
/// bricks here, of sixteen digits; refinement gives most of it back.
pub const STATIC: f64 = 1e-8;
/// Sums over the mass of orthonormal shapes: round-off of some hundred terms.
pub const ROUND_OFF: f64 = 1e-12;
/// Response by dense algebra, whose matrices have the condition of K times that of the distance to a resonance.
pub const RESPONSE: f64 = 1e-6;
/// Frequencies of two solvers of the same problem.
pub const FREQUENCY: f64 = 1e-8;
