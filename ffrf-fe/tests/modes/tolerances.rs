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
/// Frequencies of the connecting rod against LAPACK's dense solution, relative: round-off there is ε times the ratio
/// of the highest eigenvalue of the mesh to the lowest, about 1e6.
pub const LAPACK: f64 = 1e-9;
/// Residual ||K φ - λ M φ|| / ||K φ|| of a computed mode: the product K φ alone cancels as many digits as the
/// stiffest eigenvalue of the mesh lies above λ, six at most here.
pub const RESIDUAL: f64 = 1e-8;
/// Eigenvalues of a whole spectrum against each other, relative to the largest: round-off of dense solutions.
pub const WHOLE_SPECTRUM: f64 = 1e-13;
