//! The tolerances of tests, each with its reason.

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

/// Derivatives by dual numbers against formulas, of motions with rates of order one: round-off of sums of some hundred.
pub const DERIVED: f64 = 1e-12;

/// Mass matrices and quadratic velocity vectors against the reference, relative to the natural scale of each entry.
pub const REFERENCE_MATRICES: f64 = 1e-12;

/// Accelerations against the reference, relative to the largest: the figure that the reference itself states.
pub const REFERENCE_ACCELERATION: f64 = 1e-10;

/// Accelerations through a factorisation of a mass matrix with a condition number below 1e4.
pub const SOLVED: f64 = 1e-10;

/// Slow motion at ω h = 0.023 over 1000 steps of a second-order method: (ω h)² times the number of radians, 23.
pub const SLOW_MOTION_AT_LARGE_STEP: f64 = 0.02;

/// Elastic over kinetic energy of a body of stiffness 1e10 N/m that spins with some 10 N: 10 / 1e10, generously.
pub const QUIET_STIFF_MODES: f64 = 1e-6;

/// f32 after some hundred steps of numbers of order ten: 200 steps times 10 times 6e-8.
pub const SINGLE_PRECISION: f64 = 2e-4;

/// Euler parameters of the heavy top in print: the two methods printed there differ by 1.5e-4 ... 2e-4.
pub const HEAVY_TOP_IN_PRINT: f64 = 3e-4;
