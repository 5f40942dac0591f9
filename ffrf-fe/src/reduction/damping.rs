//! The modal damping D_ff.

use std::f64::consts::TAU;

use faer::{Mat, MatRef};

use crate::FeError;
use crate::modes::{cholesky, generalised_eigen};
use crate::tolerances::DIAGONAL;

use super::{Damping, DampingBand, ReductionError};

/// D_ff for a modal mass Θ_ff and a modal stiffness K_ff.
///
/// A ratio ζ_k for each eigenpair (ω_k, u_k) of K_ff u = ω² Θ_ff u, uᵀΘu = 1, gives
/// D = Θ (Σ 2 ζ_k ω_k u_k u_kᵀ) Θ, which is diag(2 ζ_μ ω_μ) for mass-normalised eigenmodes.
/// Errors: a wrong number of ratios, bands that do not ascend to infinity, a coefficient that is negative or not finite, Θ_ff not positive definite.
///
/// `second` is the unit of time of the matrices in seconds, 1 if it is not known: bands are in hertz.
pub(crate) fn modal_damping(
    damping: &Damping,
    mass: MatRef<'_, f64>,
    stiffness: MatRef<'_, f64>,
    second: f64,
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
            by_ratio(mass, stiffness, |k, _| ratios[if ratios.len() == 1 { 0 } else { k }])
        }
        Damping::Bands(bands) => {
            check_bands(bands)?;
            let last = bands.last().map_or(0.0, |band| band.ratio);
            by_ratio(mass, stiffness, |_, omega| {
                let frequency = omega / (TAU * second);
                bands.iter().find(|band| frequency < band.below).map_or(last, |band| band.ratio)
            })
        }
    }
}

/// Ratios of eigenmodes, by their place in ascending order and their circular frequency.
fn by_ratio(
    mass: MatRef<'_, f64>,
    stiffness: MatRef<'_, f64>,
    ratio: impl Fn(usize, f64) -> f64,
) -> Result<Mat<f64>, FeError> {
    if is_diagonal(mass) && is_diagonal(stiffness) {
        return Ok(diagonal_damping(mass, stiffness, ratio));
    }
    general_damping(mass, stiffness, ratio)
}

fn check_bands(bands: &[DampingBand]) -> Result<(), ReductionError> {
    for band in bands {
        non_negative("ratio", band.ratio)?;
    }
    let ascends = bands.windows(2).all(|pair| pair[0].below < pair[1].below);
    let starts = bands.first().is_some_and(|band| band.below > 0.0);
    if starts && ascends && bands.last().is_some_and(|band| band.below == f64::INFINITY) {
        return Ok(());
    }
    let found: Vec<String> = bands.iter().map(|band| band.below.to_string()).collect();
    Err(ReductionError::DampingBands { found: found.join(", ") })
}

fn diagonal_damping(
    mass: MatRef<'_, f64>,
    stiffness: MatRef<'_, f64>,
    ratio: impl Fn(usize, f64) -> f64,
) -> Mat<f64> {
    let modes = mass.nrows();
    let mut order: Vec<usize> = (0..modes).collect();
    let frequency = |mode: usize| stiffness[(mode, mode)] / mass[(mode, mode)];
    order.sort_by(|&a, &b| frequency(a).total_cmp(&frequency(b)));
    let mut result = Mat::zeros(modes, modes);
    for (k, &mode) in order.iter().enumerate() {
        let omega = frequency(mode).max(0.0).sqrt();
        result[(mode, mode)] =
            2.0 * ratio(k, omega) * (stiffness[(mode, mode)].max(0.0) * mass[(mode, mode)]).sqrt();
    }
    result
}

fn general_damping(
    mass: MatRef<'_, f64>,
    stiffness: MatRef<'_, f64>,
    ratio: impl Fn(usize, f64) -> f64,
) -> Result<Mat<f64>, FeError> {
    // Fails with the pivot if the modes are dependent on each other.
    cholesky(mass, "the modal mass matrix")?;
    let (values, vectors) = generalised_eigen(stiffness, mass)?;
    let momenta = mass * &vectors;
    let modes = mass.nrows();
    let mut result = Mat::zeros(modes, modes);
    for (k, value) in values.iter().enumerate() {
        let omega = value.max(0.0).sqrt();
        let coefficient = 2.0 * ratio(k, omega) * omega;
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Square roots of numbers of order one.
    const ROUND_OFF: f64 = 1e-14;

    fn diagonal(entries: [f64; 3]) -> Mat<f64> {
        Mat::from_fn(3, 3, |i, j| if i == j { entries[i] } else { 0.0 })
    }

    /// Modes of 50, 500 and 5000 Hz of unit mass, in another order.
    fn stiffness(unit: f64) -> Mat<f64> {
        diagonal([500.0, 50.0, 5000.0].map(|hertz| (TAU * hertz * unit).powi(2)))
    }

    #[test]
    fn bands_choose_the_ratio_by_frequency() {
        let mass = diagonal([1.0; 3]);
        for second in [1.0, 1e-3] {
            let stiffness = stiffness(second);
            let bands = Damping::common_bands();
            let found = modal_damping(&bands, mass.as_ref(), stiffness.as_ref(), second).expect("sound");
            for (mode, ratio) in [0.1, 0.01, 1.0].into_iter().enumerate() {
                let expected = 2.0 * ratio * stiffness[(mode, mode)].sqrt();
                assert!((found[(mode, mode)] - expected).abs() < ROUND_OFF * expected, "mode {mode}");
            }
        }
        // Coupled in the mass: the same ratios of the same eigenmodes.
        let turn = Mat::from_fn(3, 3, |i, j| [[1.0, 0.0, 0.0], [0.4, 1.0, 0.0], [0.0, 0.0, 1.0]][i][j]);
        let rotated = |matrix: &Mat<f64>| turn.transpose() * matrix * &turn;
        let (mass, stiffness) = (rotated(&mass), rotated(&stiffness(1.0)));
        let found =
            modal_damping(&Damping::common_bands(), mass.as_ref(), stiffness.as_ref(), 1.0).expect("sound");
        let expected = rotated(&diagonal([0.1 * 500.0, 0.01 * 50.0, 5000.0].map(|x| 2.0 * TAU * x)));
        for i in 0..3 {
            for j in 0..3 {
                let error = (found[(i, j)] - expected[(i, j)]).abs();
                // Eigenvectors of eigenvalues that differ by a factor of 1e4.
                assert!(error < 1e-9 * expected[(2, 2)], "({i}, {j}): {error:e}");
            }
        }
    }

    #[test]
    fn bands_that_leave_a_gap_are_refused() {
        let mass = diagonal([1.0; 3]);
        let band = |below, ratio| DampingBand { below, ratio };
        for bands in [vec![], vec![band(100.0, 0.1)], vec![band(f64::INFINITY, 0.1), band(100.0, 0.2)]] {
            let damping = Damping::Bands(bands);
            let error = modal_damping(&damping, mass.as_ref(), mass.as_ref(), 1.0).expect_err("a gap");
            assert!(error.to_string().contains("ascending"), "{error}");
        }
        let damping = Damping::Bands(vec![band(f64::INFINITY, -0.1)]);
        assert!(modal_damping(&damping, mass.as_ref(), mass.as_ref(), 1.0).is_err());
    }
}
