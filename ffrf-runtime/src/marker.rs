//! Markers: points of a flexible body where forces act and where motion is observed.

use nalgebra::{RealField, SVector, Vector3};

/// A point of a flexible body with `M` modes, with the rows of the mode shapes there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Marker<const M: usize, T = f64> {
    /// Reference position in the body frame. Units: m.
    pub position: [T; 3],
    /// Displacement per unit modal coordinate, φ_μ at the marker. Shape: M x 3.
    pub translation: [[T; 3]; M],
    /// Small rotation per unit modal coordinate. Shape: M x 3. Units: rad.
    pub rotation: [[T; 3]; M],
}

impl<const M: usize, T: RealField + Copy> Marker<M, T> {
    /// Position from the frame origin in the deformed state, x + Ψ q.
    ///
    /// Shape: 3. Units: m. Frame: body. Panics: never.
    pub fn position(&self, q: &SVector<T, M>) -> Vector3<T> {
        Vector3::from(self.position) + combine(&self.translation, q)
    }
}

/// Σ_μ rows_μ c_μ.
fn combine<const M: usize, T: RealField + Copy>(
    rows: &[[T; 3]; M],
    coefficients: &SVector<T, M>,
) -> Vector3<T> {
    let mut sum = Vector3::zeros();
    for mu in 0..M {
        sum += Vector3::from(rows[mu]) * coefficients[mu];
    }
    sum
}
