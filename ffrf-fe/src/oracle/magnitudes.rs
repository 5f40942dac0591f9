//! The natural magnitude of each quantity, to measure deviations by.

/// Magnitudes that the Cauchy-Schwarz inequality in the mass inner product gives to each quantity.
///
/// Every entry of the mass matrix is an inner product of two columns of J, every gyroscopic force one of a
/// column with the convective acceleration γ, and so on. The product of the two norms bounds the quantity and
/// is the scale of its round-off; it does not vanish where the quantity does (free-free modes have B = 0).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// Largest norm of a column of J, for translations, rotations and modes.
    pub column: [f64; 3],
    /// Norm of the convective acceleration γ.
    pub convective: f64,
    /// Norm of the velocity field, √(2 E).
    pub velocity: f64,
}

impl Scales {
    pub(super) fn new(mass_matrix: &[Vec<f64>], convective_square: f64, kinetic_energy: f64) -> Self {
        let mut column = [0.0_f64; 3];
        for (index, row) in mass_matrix.iter().enumerate() {
            let group = group_of(index);
            column[group] = column[group].max(row[index].max(0.0).sqrt());
        }
        Self {
            column,
            convective: convective_square.max(0.0).sqrt(),
            velocity: (2.0 * kinetic_energy).max(0.0).sqrt(),
        }
    }
}

/// 0 for translations, 1 for rotations, 2 for modes.
pub fn group_of(index: usize) -> usize {
    (index / 3).min(2)
}
