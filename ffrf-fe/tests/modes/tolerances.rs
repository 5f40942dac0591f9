//! The tolerances of these tests, each with its reason.

/// Eigenfrequencies against the reference, relative: what the project promises.
pub const REFERENCE_FREQUENCY: f64 = 1e-6;
/// Invariants against the reference, relative to the largest entry of the block: round-off of sums over the nodes.
pub const INVARIANTS: f64 = 1e-12;
/// First moments of free-free modes are zero up to round-off: compared against mass times size.
pub const ZERO_MOMENT: f64 = 1e-12;
/// Mass orthogonality of computed modes: round-off of one product.
pub const ORTHOGONALITY: f64 = 1e-12;
/// Dense against sparse frequencies, relative: both end with Rayleigh quotients, exact to the square of the
/// shape's error; what is left is round-off of K times the spread of the spectrum.
pub const TWO_SOLVERS: f64 = 1e-9;
/// Bricks against Euler-Bernoulli beams of slenderness 50, relative. Shear and rotary inertia lower the second
/// frequency by about half a percent; trilinear elements with an edge ratio of 2 raise it by one to two.
pub const SLENDER_BEAM: f64 = 0.02;
/// A rigid rotation through a marker's fit: round-off of a 3 x 3 inverse.
pub const MARKER: f64 = 1e-12;
