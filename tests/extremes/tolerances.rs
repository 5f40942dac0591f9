//! The bounds of the extremes, each with its reason: double precision first, single precision second.

/// Drift of energy and angular momentum of a rigid body in 1e4 steps of 0.01 rad: RK4 loses some (h ω)⁶ / 100 per step of
/// energy, 1e-10 in all, single precision a rounding of 6e-8 in each, which add up like a random walk, 6e-6, or worse.
pub const TUMBLING: [f64; 2] = [1e-9, 1e-4];

/// Drift of energy of a rod that vibrates or turns, in 2,000 steps of which the highest mode sees h ω = 0.14: RK4 loses
/// (h ω)⁶ / 72 of the energy of a mode per step, 1e-7 of the highest and 2e-4 in all.
pub const VIBRATING: [f64; 2] = [2e-4, 4e-4];

/// The same over 1e5 steps, ten times as many: RK4 loses ten times as much. Single precision: 1e5 roundings of 6e-8, all to one
/// side, would be 6e-3; they are not all to one side.
pub const LONG_ENERGY: [f64; 2] = [1e-8, 1e-3];

/// Angular momentum in space has the error of the orientation in it besides, which adds up as that of the spin does.
pub const LONG_MOMENTUM: [f64; 2] = [1e-8, 1e-3];

/// A quaternion is divided by its norm in every step: two roundings.
pub const UNIT_QUATERNION: [f64; 2] = [4.0 * f64::EPSILON, 4.0 * f32::EPSILON as f64];

/// A pendulum of 1 m in 1,000 steps of 1 ms: RK4 is far below, and single precision rounds energies and places, 1 m and 10 J,
/// a thousand times by 6e-8 of them. A second body of any mass costs no digits: in a sweep over a tree the motion that a joint
/// leaves is divided by what resists it, and masses are not taken from each other.
pub const PENDULUM: [f64; 2] = [1e-8, 1e-3];

/// 1,000 steps of 0.01 rad: RK4 shifts the phase by (h ω)⁴ / 120 per radian, 1e-9 in all; rounding adds its part, and what is
/// left of the frame beside a mode of `ratio` times its mass has lost that many units of the last place, of which the
/// frequency has half and the phase 10 rad.
pub fn vibration_of_ratio(ratio: f64) -> [f64; 2] {
    [f64::EPSILON, f32::EPSILON.into()].map(|epsilon| 1e-8 + 100.0 * epsilon * (1.0 + ratio).max(10.0))
}

/// A mode whose mass is in the centre of a turning frame is not driven at all; what is left is rounding of a place of 5 m, a
/// thousand times.
pub const FRAME_OF_STIFF_MODE: [f64; 2] = [1e-11, 1e-2];

/// After 1 s nothing is left of vibrations of more than 100 rad/s that are damped half critically; a spring finds its length
/// as a difference of places of 1 m, and its force is that of one unit in the last place of it.
pub const STIFF_SPRING: [f64; 2] = [1e-11, 1e-5];

/// Accelerations through a mass matrix with a condition number of some 10 / ε²; rounding of its entries is solved with.
pub fn same_span(epsilon: f64) -> [f64; 2] {
    [f64::EPSILON, f32::EPSILON.into()].map(|rounding| 100.0 * rounding / (epsilon * epsilon))
}

/// Amplitudes that do not grow: in symplectic Euler near its limit places and velocities are far from those of the energy that
/// it keeps, by 1 / √(1 - 0.99²) = 7.
pub const BOUNDED: [f64; 2] = [10.0, 10.0];

/// A chain in 50 steps of 1 ms: RK4 far below; its far end is 1,000 m away, of which single precision has 6e-5 m, and energies
/// are sums over the height of all links.
pub const CHAIN: [f64; 2] = [1e-8, 0.3];

/// Ten times as many links take the same work each; the first and the last link take less.
pub const LINEAR_COST: f64 = 1.1;

/// A door on hinges: their reactions are found by a shift of 1e-9 (1e-3 in single precision) that refinements take out again,
/// over 1,000 steps.
pub const REDUNDANT: [f64; 2] = [1e-9, 1e-3];

/// Through a singular position in steps of 0.01 rad: the regularisation gives way there, and what velocity is lost by
/// projection onto rows that appear again is not given back.
pub const SINGULAR: [f64; 2] = [1e-3, 1e-2];

/// The same sums with factors that are no powers of two: every constant and every step rounds differently, for 500 steps.
/// Projections end at residuals of 16 roundings of one unit of length, 3.5e-12 m where it is a kilometre, which stiff modes
/// answer at once.
pub const SAME_IN_UNITS: [f64; 2] = [1e-6, 1e-2];
