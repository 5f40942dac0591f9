//! The bound of these tests, with its reason.

/// Largest ratio of an error of ours to that of a Cholesky factorisation of the same mass matrix.
///
/// Both solve equations within rounding of the same matrix, so that both errors are some constant times ε κ. The
/// constants differ: the order of elimination and of the sums is another one, and products may be fused. Four is what
/// issue 9 asks for. Found over 8 to 10 bodies of each kind: at most 2.8 for the largest error of all accelerations scaled
/// by mass, and 2.2 for the root of the mean square in the other norms; for the single bodies with 32 and 64 modes 3.2.
pub const RATIO: f64 = 4.0;

/// With fewer bodies of a kind than this, only the norm scaled by mass is compared. The error of a part that is a small
/// share of the whole can hang on one rounding of one constant of the body, lucky for the one order of elimination and
/// not for the other: up to 50 times, either way, for a single body.
pub const BODIES_FOR_PARTS: u64 = 8;

/// Most that the error of a Cholesky factorisation may be, in units of ε κ: it has to be a yardstick.
///
/// N ε κ with N up to 70 is the factorisation (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed.,
/// theorem 10.4); a gyroscopic force of larger terms that cancel is the rest, an error of the right-hand side for both.
/// For that the square root of the condition that the family is asked for is added to κ. Found: at most 110.
pub const YARDSTICK: f64 = 500.0;

/// Bodies whose ε κ exceeds this are not compared: hardly a digit is certain, and a factorisation in this precision
/// comes near to failing.
pub const DIGITS: f64 = 0.1;
