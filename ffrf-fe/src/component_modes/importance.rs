//! What a mode matters to the interfaces.

use faer::{Mat, MatRef};

/// Share of each mode in the static compliance of the interfaces.
///
/// Mode k adds b_k² / ω_k² to the compliance of a motion with the participation b_k = Bφ_k; its importance is the
/// largest share that it has of the elastic compliance of any motion of the full model.
/// `motion` is B Φ for orthonormal modes (rows: motions), `compliance` the diagonal of B G_e Bᵀ.
pub(crate) fn compliance_shares(motion: MatRef<'_, f64>, values: &[f64], compliance: &[f64]) -> Vec<f64> {
    (0..motion.ncols())
        .map(|k| {
            (0..motion.nrows()).fold(0.0_f64, |largest, i| {
                let share = motion[(i, k)].powi(2) / (values[k] * compliance[i]);
                if share.is_finite() { largest.max(share) } else { largest }
            })
        })
        .collect()
}

/// Least part of the static compliance of any interface motion that the modes hold together; 1 if it is complete.
pub(crate) fn compliance_kept(motion: MatRef<'_, f64>, values: &[f64], compliance: &[f64]) -> f64 {
    (0..motion.nrows())
        .filter(|&i| compliance[i] > 0.0)
        .map(|i| (0..motion.ncols()).map(|k| motion[(i, k)].powi(2) / values[k]).sum::<f64>() / compliance[i])
        .fold(1.0, f64::min)
}

/// Share of each clamped mode in the mass that an interface motion accelerates.
///
/// The interface motion i takes the mass (Ψ_cᵀMΨ_c)_ii along; mode k adds (φ_kᵀMψ_i)² of it. The largest share over
/// all motions is the effective mass of the mode.
pub(crate) fn effective_mass_shares(coupling: &Mat<f64>, interface_mass: &Mat<f64>) -> Vec<f64> {
    (0..coupling.nrows())
        .map(|k| {
            (0..coupling.ncols()).fold(0.0_f64, |largest, i| {
                let share = coupling[(k, i)].powi(2) / interface_mass[(i, i)];
                if share.is_finite() { largest.max(share) } else { largest }
            })
        })
        .collect()
}
