//! How far invariants may miss what they should be, each with its reason.

/// Difference of numbers that should be equal, relative to the size that the entry can have.
///
/// Products of norms bound the entries (Cauchy-Schwarz): T by tr T, T_μ by √(tr T · Θ_μμ), T_μν and Θ_ff by
/// √(Θ_μμ Θ_νν); K_ff and D_ff are compared with their largest entry. Ten typed digits leave 1e-10; a transposed
/// block or a wrong sign leaves the order of 1.
pub(super) const AGREEMENT: f64 = 1e-9;

/// How far below zero T may be in some direction, relative to its trace: as [`AGREEMENT`], of three entries.
pub(super) const NEGATIVE: f64 = 1e-9;

/// Least pivot of rotational inertia over its diagonal entry: all mass is on a line through the frame origin
/// (inertia tensor), or on any line (mass matrix). A body of length to thickness 1e6 in a frame askew has 1e-12,
/// round-off of the elimination is 1e-15.
pub(super) const RIGID: f64 = 1e-13;

/// Least pivot of a mode over its modal mass: how much of it is neither rigid motion nor modes before it. At
/// 1e-10, accelerations keep about six of sixteen digits.
pub(super) const INDEPENDENCE: f64 = 1e-10;

/// The limit in a number type whose numbers next to 1 are `epsilon` apart: single precision cannot keep limits that are
/// below its own rounding in the sums of a few entries.
pub(super) fn limit(in_double_precision: f64, epsilon: f64) -> f64 {
    in_double_precision.max(16.0 * epsilon)
}
