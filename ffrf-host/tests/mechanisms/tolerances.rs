//! How exact a solved mechanism is, with reasons.

/// Errors of accelerations and multipliers over ε κ, in units in which every diagonal entry of the system is one.
///
/// κ: condition number of that system. Every backward stable solver keeps such a bound; the constant grows with the size
/// of the system, some ten here.
pub const SOLVED: f64 = 20.0;

/// What is left of the shift μ = 1e-9 of the rows after its two refinements: (μ / (σ + μ))³ for the smallest σ, about 1 / κ.
pub fn left_by_regularisation(condition: f64) -> f64 {
    (1e-9 * condition).powi(3)
}

/// What the equations leave over, relative to the sizes of their terms: sums of some hundred products once
/// refinements have taken out what an elimination without pivots loses.
pub const RESIDUAL: f64 = 1e-12;

/// Power of joint reactions over the product of the norms of reactions and velocities, at states that meet the joints' rates to round-off.
pub const POWER: f64 = 1e-13;

/// Balances of momentum with derivatives by dual numbers and accelerations from a solve with condition numbers below 1e6.
pub const BALANCE: f64 = 1e-9;
