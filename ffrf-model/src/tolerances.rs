//! Limits of the consistency checks, all in one place, each with its reason.

/// Largest asymmetry that is accepted, relative to the largest entry.
///
/// A reduction from FE data leaves 1e-15; a file typed with ten digits leaves 1e-10. What a transposed block
/// or a wrong sign leaves is of the order of 1.
pub(crate) const SYMMETRY: f64 = 1e-9;

/// How far below zero the smallest eigenvalue of a matrix scaled to unit size may lie.
///
/// Round-off of a Gram matrix with thousands of terms stays below 1e-12; ten typed digits leave 1e-9 at worst.
/// A kinetic energy that is negative for some motion shows as far more.
pub(crate) const NEGATIVE_EIGENVALUE: f64 = -1e-9;

/// Least share of a mode combination's kinetic energy that rigid motion must not be able to express.
///
/// The mass matrix M(q) has a condition number of about its reciprocal: at 1e-10, accelerations keep about
/// six of sixteen digits.
pub(crate) const INDEPENDENCE: f64 = 1e-10;

/// Least pivot of the rigid-body block scaled to a unit diagonal, below which the body has no inertia about
/// some axis (all mass on a line, or in a point): round-off of the elimination is 1e-15.
pub(crate) const RIGID_PIVOT: f64 = 1e-13;

/// Least share of a mode, both of unit modal mass, from which a message names it as part of a combination.
///
/// Modes that are accepted have a condition of up to 1e10, so that shares carry errors of up to 1e-6.
pub(crate) const PARTICIPATION: f64 = 1e-3;
