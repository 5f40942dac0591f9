//! Limits of the checks on files, models and bodies, all in one place, each with its reason. What an algorithm needs to
//! converge stands beside the algorithm.

/// Largest difference of mirrored entries, relative to the largest entry of the matrix. FE codes print 14 to 17
/// digits, so mirrored entries agree to 1e-13; a wrong entry differs by far more.
pub(crate) const SYMMETRY_TOLERANCE: f64 = 1e-9;

/// Largest deviation of M_FE from M_s ⊗ I3, relative to its largest entry. Displacement elements with consistent
/// or lumped mass are isotropic to the digits printed (14 and more); rotary or added directional masses are not.
pub(crate) const ISOTROPY_TOLERANCE: f64 = 1e-9;

/// Negative eigenvalues of the matrix scaled to unit diagonal down to minus this are round-off: exports print 14
/// digits and more, and the factorisation of a few 100,000 rows adds about 1e-12.
pub(crate) const DEFINITENESS_TOLERANCE: f64 = 1e-9;

/// Pivots below this, of the matrix scaled to unit diagonal and shifted by [`DEFINITENESS_TOLERANCE`], stand for
/// eigenvalues of zero. Masses of sound elements leave pivots above 1e-3; an eigenvalue of zero leaves 1e-9 times the
/// number of nodes that its vector is spread over.
pub(crate) const VANISHING_PIVOT: f64 = 1e-5;

/// Least diagonal entry that stands for a support. Abaqus writes 1e36 on the diagonal of degrees of freedom that
/// boundary conditions hold.
pub(crate) const HELD_DIAGONAL: f64 = 1e35;

/// Force of a rigid rotation over that of its parts, |K r| / (|K| |r|), up to which nothing is said. Coordinates and
/// matrices printed to 14 digits give 1e-14; 8 digits give about 1e-8; a coordinate off by 0.1 % gives 4e-5.
pub(crate) const ROTATION_FORCE: f64 = 1e-7;

/// A translation needs no force whatever the coordinates are: nodes with more than this, relative, are held by
/// something outside, or are neighbours of held ones, and say nothing about coordinates.
pub(crate) const TRANSLATION_FORCE: f64 = 1e-9;

/// Nodes closer to one line than this part of their extent do not define a rotation: coordinates of eight digits leave
/// four digits of it.
pub(crate) const SPREAD: f64 = 1e-4;

/// Largest asymmetry of a given modal stiffness, relative to its largest entry: eight decimals in a text file.
pub(crate) const MODAL_STIFFNESS_ASYMMETRY: f64 = 1e-8;

/// Largest coupling of two computed eigenmodes, relative to √(K_μμ K_νν), that is left out as the solver's residual:
/// small enough for the elastic energy to stay within the 1e-12 that `ffrf verify` asks for.
pub(crate) const RESIDUAL_COUPLING: f64 = 5e-13;

/// Off-diagonal entries below this part of the geometric mean of their diagonals make a matrix diagonal, so that modes
/// are damped one by one: eigenmodes computed elsewhere and printed to ten digits pass.
pub(crate) const DIAGONAL: f64 = 1e-9;

/// Round-off of the mean-axis conditions, relative to the Gram scales √(m tr T_μμ) and √(tr T tr T_μμ), that is cleared:
/// sums over 100,000 nodes leave 1e-14, residuals of eigenmodes 1e-13.
pub(crate) const MEAN_AXIS_ROUND_OFF: f64 = 1e-12;
