//! Eigenvalues and eigenvectors of a linearised mechanism.

use faer::Mat;
use nalgebra::{Complex, DMatrix, DVector};

use super::AnalysisError;

/// One eigenvalue, or one of a pair.
#[derive(Debug, Clone, PartialEq)]
pub struct Eigenmode {
    /// λ; of a pair the one whose imaginary part is positive. Units: 1/s.
    pub eigenvalue: Complex<f64>,
    /// The eigenvector in the coordinates of the state space, of unit length.
    pub vector: DVector<Complex<f64>>,
}

impl Eigenmode {
    /// Undamped natural frequency |λ| / 2π; zero for an eigenvalue without an imaginary part. Units: Hz.
    pub fn frequency_hz(&self) -> f64 {
        if self.eigenvalue.im > 0.0 { self.eigenvalue.norm() / std::f64::consts::TAU } else { 0.0 }
    }

    /// Damping ratio -Re λ / |λ|: 1 for a real negative eigenvalue, negative where motion grows; zero for λ = 0.
    pub fn damping_ratio(&self) -> f64 {
        let size = self.eigenvalue.norm();
        if size > 0.0 { -self.eigenvalue.re / size } else { 0.0 }
    }
}

/// Eigenvalues and vectors of A (2f x 2f: f places, f velocities), one of each pair, by rising |Im λ|, then |λ|.
///
/// Eigenvalues are found to some round-off of the *largest*: where motion is free, pairs near zero appear that are the root of
/// this, about 1e-8 of the largest.
///
/// Errors: the iteration does not converge.
pub fn eigenmodes(a: &DMatrix<f64>) -> Result<Vec<Eigenmode>, AnalysisError> {
    let (size, half) = (a.nrows(), a.nrows() / 2);
    if size == 0 {
        return Ok(Vec::new());
    }
    // places in units in which they are as large as velocities: both halves of the matrix are alike then
    let stiffness = a.view((half, 0), (size - half, half)).norm();
    let scale = if stiffness > 0.0 { stiffness.sqrt() } else { 1.0 };
    let unit = |i: usize| if i < half { scale } else { 1.0 };
    let what = "the eigenvalue iteration";
    let found = Mat::from_fn(size, size, |i, j| a[(i, j)] * unit(i) / unit(j))
        .eigen()
        .map_err(|_| AnalysisError::NotConverged { what })?;
    let (values, vectors) = (found.S().column_vector(), found.U());
    let mut modes: Vec<Eigenmode> = (0..size)
        .filter(|k| values[*k].im >= 0.0)
        .map(|k| {
            let entry = |i: usize| Complex::new(vectors[(i, k)].re, vectors[(i, k)].im) / unit(i);
            let vector = DVector::from_fn(size, |i, _| entry(i));
            let length = vector.norm();
            Eigenmode {
                eigenvalue: Complex::new(values[k].re, values[k].im),
                vector: vector.unscale(if length > 0.0 { length } else { 1.0 }),
            }
        })
        .collect();
    modes.sort_by(|a, b| {
        let key = |mode: &Eigenmode| (mode.eigenvalue.im, mode.eigenvalue.norm(), mode.eigenvalue.re);
        let (a, b) = (key(a), key(b));
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.total_cmp(&b.2))
    });
    Ok(modes)
}
