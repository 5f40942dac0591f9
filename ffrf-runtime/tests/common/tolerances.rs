//! Every tolerance of the tests of this crate, with its reason.

/// Identities between a few sums and products of numbers of order one: some hundred roundings.
pub const ROUND_OFF: f64 = 1e-12;

/// Deviation of a measured order of convergence from the theoretical one, in the asymptotic range.
pub const SLOPE: f64 = 0.15;

/// Free trajectory against the reference, relative to the largest value of each block: the figure.
pub const REFERENCE_TRAJECTORY: f64 = 1e-8;

/// Drift of conserved quantities in RK4 runs whose step is stated in the test to make h⁴ this small.
pub const CONSERVED_BY_RK4: f64 = 1e-9;

/// A centred difference with step 1e-5 of functions of order one: h² plus eps / h.
pub const CENTRED_DIFFERENCE: f64 = 1e-8;
