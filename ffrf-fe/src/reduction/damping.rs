//! The modal damping D_ff.

use faer::{Mat, MatRef};

use crate::FeError;
use crate::modes::{cholesky, generalised_eigen};
use crate::tolerances::DIAGONAL;

use super::{Damping, ReductionError};

/// D_ff for a modal mass Θ_ff and a modal stiffness K_ff.
///
/// A ratio ζ_k for each eigenpair (ω_k, u_k) of K_ff u = ω² Θ_ff u, uᵀΘu = 1, gives
/// D = Θ (Σ 2 ζ_k ω_k u_k u_kᵀ) Θ, which is diag(2 ζ_μ ω_μ) for mass-normalised eigenmodes.
/// Errors: a wrong number of ratios, a coefficient that is negative or not finite, Θ_ff not positive definite.
pub(crate) fn modal_damping(
    damping: &Damping,
    mass: MatRef<'_, f64>,
    stiffness: MatRef<'_, f64>,
) -> Result<Mat<f64>, FeError> {
    let modes = mass.nrows();
    match damping {
        Damping::None => Ok(Mat::zeros(modes, modes)),
        Damping::Rayleigh { alpha, beta } => {
            non_negative("alpha", *alpha)?;
            non_negative("beta", *beta)?;
            Ok(Mat::from_fn(modes, modes, |i, j| alpha * mass[(i, j)] + beta * stiffness[(i, j)]))
        }
        Damping::ModalRatio(ratios) => {
            if ratios.len() != 1 && ratios.len() != modes {
                return Err(ReductionError::DampingCount { modes, found: ratios.len() }.into());
            }
            for &ratio in ratios {
                non_negative("ratio", ratio)?;
            }
            let ratio = |k: usize| ratios[if ratios.len() == 1 { 0 } else { k }];
            if is_diagonal(mass) && is_diagonal(stiffness) {
                return Ok(diagonal_damping(mass, stiffness, ratio));
            }
            general_damping(mass, stiffness, ratio)
        }
    }
}

fn diagonal_damping(
    mass: MatRef<'_, f64>,
    stiffness: MatRef<'_, f64>,
    ratio: impl Fn(usize) -> f64,
) -> Mat<f64> {
    let modes = mass.nrows();
    let mut order: Vec<usize> = (0..modes).collect();
    let frequency = |mode: usize| stiffness[(mode, mode)] / mass[(mode, mode)];
    order.sort_by(|&a, &b| frequency(a).total_cmp(&frequency(b)));
    let mut result = Mat::zeros(modes, modes);
    for (k, &mode) in order.iter().enumerate() {
        result[(mode, mode)] =
            2.0 * ratio(k) * (stiffness[(mode, mode)].max(0.0) * mass[(mode, mode)]).sqrt();
    }
    result
}

fn general_damping(
    mass: MatRef<'_, f64>,
    stiffness: MatRef<'_, f64>,
    ratio: impl Fn(usize) -> f64,
) -> Result<Mat<f64>, FeError> {
    // Fails with the pivot if the modes are dependent on each other.
    cholesky(mass, "the modal mass matrix")?;
    let (values, vectors) = generalised_eigen(stiffness, mass)?;
    let momenta = mass * &vectors;
    let modes = mass.nrows();
    let mut result = Mat::zeros(modes, modes);
    for (k, value) in values.iter().enumerate() {
        let coefficient = 2.0 * ratio(k) * value.max(0.0).sqrt();
        for j in 0..modes {
            for i in 0..=j {
                let term = coefficient * momenta[(i, k)] * momenta[(j, k)];
                result[(i, j)] += term;
                if i != j {
                    result[(j, i)] += term;
                }
            }
        }
    }
    Ok(result)
}

fn is_diagonal(matrix: MatRef<'_, f64>) -> bool {
    (0..matrix.ncols()).all(|j| {
        (0..j).all(|i| {
            let scale = (matrix[(i, i)] * matrix[(j, j)]).abs().sqrt();
            matrix[(i, j)].abs() <= DIAGONAL * scale
        })
    })
}

fn non_negative(what: &str, value: f64) -> Result<(), ReductionError> {
    if value.is_finite() && value >= 0.0 {
        return Ok(());
    }
    Err(ReductionError::NegativeDamping { what: what.to_owned(), value })
}
