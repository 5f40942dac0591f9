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
    /// A marker on the rigid part of a body: the modes do not move it.
    ///
    /// Panics: never.
    pub fn rigid(position: [T; 3]) -> Self {
        Self { position, translation: [[T::zero(); 3]; M], rotation: [[T::zero(); 3]; M] }
    }

    /// Position from the frame origin in the deformed state, x + Ψ q.
    ///
    /// Shape: 3. Units: m. Frame: body. Panics: never.
    pub fn position(&self, q: &SVector<T, M>) -> Vector3<T> {
        Vector3::from(self.position) + combine(&self.translation, q)
    }

    /// Velocity of the marker, v + ω × (x + Ψ q) + Ψ q̇, where v is that of the frame origin.
    ///
    /// Shape: 3. Units: m/s. Frame: inertial velocity resolved in the body frame. Panics: never.
    pub fn velocity(
        &self,
        q: &SVector<T, M>,
        velocity: &Vector3<T>,
        omega: &Vector3<T>,
        q_dot: &SVector<T, M>,
    ) -> Vector3<T> {
        velocity + omega.cross(&self.position(q)) + combine(&self.translation, q_dot)
    }

    /// Small rotation of the material at the marker relative to the body frame, as a rotation vector.
    ///
    /// Shape: 3. Units: rad. Frame: body. Panics: never.
    pub fn small_rotation(&self, q: &SVector<T, M>) -> Vector3<T> {
        combine(&self.rotation, q)
    }

    /// Angular velocity of the material at the marker, ω plus the rate of the small rotation.
    ///
    /// Shape: 3. Units: rad/s. Frame: body. Panics: never.
    pub fn angular_velocity(&self, omega: &Vector3<T>, q_dot: &SVector<T, M>) -> Vector3<T> {
        omega + combine(&self.rotation, q_dot)
    }

    /// Generalised force of a force f̄ at the marker: [f̄; (x + Ψ q) × f̄; φ_μ · f̄].
    ///
    /// Dual to [`velocity`](Self::velocity): its power is f̄ times the marker's velocity.
    /// Shape: N = 6 + M. Units: N, N m, N m per unit modal coordinate. Frame: body.
    /// Source: (199)-(201) with the deformed lever arm. Panics: never (N is checked when compiling).
    pub fn force<const N: usize>(&self, q: &SVector<T, M>, force: &Vector3<T>) -> SVector<T, N> {
        generalised_force(*force, self.position(q).cross(force), &self.translation, force)
    }

    /// Generalised force of a moment τ at the marker: [0; τ; rotation_μ · τ].
    ///
    /// Dual to [`angular_velocity`](Self::angular_velocity).
    /// Shape: N = 6 + M. Units: N, N m, N m per unit modal coordinate. Frame: body.
    /// Panics: never (N is checked when compiling).
    pub fn moment<const N: usize>(&self, moment: &Vector3<T>) -> SVector<T, N> {
        generalised_force(Vector3::zeros(), *moment, &self.rotation, moment)
    }
}

/// [translational; rotational; rows_μ · dual].
fn generalised_force<const M: usize, const N: usize, T: RealField + Copy>(
    translational: Vector3<T>,
    rotational: Vector3<T>,
    rows: &[[T; 3]; M],
    dual: &Vector3<T>,
) -> SVector<T, N> {
    const { assert!(N == 6 + M, "a body with M modes has N = 6 + M velocities") };
    let mut result = SVector::zeros();
    for i in 0..3 {
        result[i] = translational[i];
        result[3 + i] = rotational[i];
    }
    for mu in 0..M {
        result[6 + mu] = Vector3::from(rows[mu]).dot(dual);
    }
    result
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
