//! Numbers for symbols: small whole quarters, so that they are exact in every arithmetic.

use ffrf_codegen::expression::{Input, Symbol};
use ffrf_codegen::invariants::Invariant;

/// A reproducible value in -1, -3/4, ..., 1 for each symbol and seed, in quarters.
fn quarters(symbol: Symbol, seed: u64) -> i32 {
    // FNV-1a over the name: any fixed mixing function does.
    let mut hash = 0xcbf2_9ce4_8422_2325_u64 ^ seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    for byte in symbol.to_string().bytes() {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    }
    ((hash >> 33) % 9) as i32 - 4
}

/// Entry of a lower triangular L with 2 on the diagonal.
fn lower(mu: usize, nu: usize, seed: u64) -> f64 {
    match mu.cmp(&nu) {
        std::cmp::Ordering::Less => 0.0,
        std::cmp::Ordering::Equal => 2.0,
        std::cmp::Ordering::Greater => {
            f64::from(quarters(Symbol::Intermediate("lower", 10 * mu + nu), seed)) / 8.0
        }
    }
}

/// Θ_ff = L Lᵀ: positive definite, with rational Cholesky factors.
fn modal_mass(mu: usize, nu: usize, seed: u64) -> f64 {
    (0..=mu.min(nu)).map(|k| lower(mu, k, seed) * lower(nu, k, seed)).sum()
}

/// The value of a symbol: a body whose mass matrix is positive definite, in some motion.
///
/// Mass 5, moments of inertia of about 12, couplings of at most a quarter: the diagonal dominates.
pub fn value(symbol: Symbol, seed: u64) -> f64 {
    let quarter = f64::from(quarters(symbol, seed)) / 4.0;
    match symbol {
        Symbol::Parameter(Invariant::Mass, _) => 5.0,
        Symbol::Parameter(Invariant::SecondMoment, [i, j, ..]) if i == j => 6.0 + quarter,
        // The trace of T_μν is Θ_ff,μν: T_μν^{xx} is what the other two leave.
        Symbol::Parameter(Invariant::ModeModeMoment, [mu, nu, 0, 0]) => {
            let other = |i| value(Invariant::ModeModeMoment.at([mu, nu, i, i]), seed);
            modal_mass(mu, nu, seed) - other(1) - other(2)
        }
        Symbol::Parameter(Invariant::ModeModeMoment, [mu, nu, i, j]) if mu == nu && i == j => {
            1.0 + quarter / 4.0
        }
        Symbol::Parameter(Invariant::Stiffness, [mu, nu, ..]) if mu == nu => 40.0 + quarter,
        Symbol::Parameter(Invariant::ModalMass | Invariant::Stiffness | Invariant::Damping, _) => quarter,
        Symbol::Parameter(..) | Symbol::Input(Input::COORDINATES, _) => quarter / 4.0,
        _ => quarter,
    }
}
