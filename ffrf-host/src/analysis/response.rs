//! Frequency response of a linear system.

use nalgebra::{Complex, DMatrix};

use super::{AnalysisError, StateSpace};

/// H(iω) = C (iω I - A)⁻¹ B + D for each frequency (Hz). Shape of each: outputs x inputs.
///
/// Errors: a frequency at which the undamped system is in resonance to round-off has no response.
pub fn frequency_response(
    system: &StateSpace,
    frequencies_hz: &[f64],
) -> Result<Vec<DMatrix<Complex<f64>>>, AnalysisError> {
    let complex = |matrix: &DMatrix<f64>| matrix.map(|x| Complex::new(x, 0.0));
    let (a, b, c, d) = (complex(&system.a), complex(&system.b), complex(&system.c), complex(&system.d));
    let size = a.nrows();
    frequencies_hz
        .iter()
        .map(|frequency| {
            if !(frequency.is_finite() && *frequency >= 0.0) {
                let expected = "a frequency that is not negative, in Hz";
                return Err(AnalysisError::Value {
                    what: "frequency",
                    expected,
                    found: frequency.to_string(),
                });
            }
            let omega = Complex::new(0.0, std::f64::consts::TAU * frequency);
            let pencil = DMatrix::from_diagonal_element(size, size, omega) - &a;
            let what = "the response at a resonance without damping";
            let x = pencil.lu().solve(&b).ok_or(AnalysisError::NotConverged { what })?;
            Ok(&c * x + &d)
        })
        .collect()
}
