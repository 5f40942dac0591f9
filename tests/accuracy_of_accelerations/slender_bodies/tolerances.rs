//! The tolerances of these tests, with their reasons.
//!
//! Errors are measured in units of ε (κ + 1 / thickness): κ is the condition number of the mass matrix scaled to a unit
//! diagonal, which bounds that of every Schur complement of it. In a frame along the body κ is about 10, askew it is
//! about thickness⁻². The second part is the right-hand side: the gyroscopic moment about the long axis is a difference
//! of terms of order one, divided by the square root of a moment of inertia, which is the thickness.

/// Errors of accelerations, forward in the norm of the scaled mass matrix, backward row by row. Found: at most 1, of
/// roundings that mostly cancel.
pub const ACCELERATION: f64 = 16.0;

/// Backward error of a Cholesky factorisation in units of ε / thickness: no condition number enters. Found: at most 1.
pub const FACTORISED: f64 = 16.0;
