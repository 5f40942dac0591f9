//! Markers: points of a flexible body where forces act and where motion is observed.

use nalgebra::{RealField, SMatrix, SVector, UnitQuaternion, Vector3};

use crate::LeverArm;
use crate::forms::angular_velocity_matrix;

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

impl<const M: usize> Marker<M, f64> {
    /// The marker in another number type: of a generic body, whose constants are f64, for dual numbers, say.
    ///
    /// Panics: never.
    pub fn cast<T: RealField + Copy>(&self) -> Marker<M, T> {
        let vector = |numbers: [f64; 3]| numbers.map(nalgebra::convert);
        Marker {
            position: vector(self.position),
            translation: self.translation.map(vector),
            rotation: self.rotation.map(vector),
        }
    }
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

    /// The position that forces and constraints turn the body about: x + Ψ q, or x alone.
    ///
    /// Shape: 3. Units: m. Frame: body. Panics: never.
    pub fn lever_arm(&self, q: &SVector<T, M>, lever_arm: LeverArm) -> Vector3<T> {
        match lever_arm {
            LeverArm::Deformed => self.position(q),
            LeverArm::Undeformed => Vector3::from(self.position),
        }
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

    /// [`force`](Self::force) about the lever arm of choice: [f̄; l × f̄; φ_μ · f̄].
    ///
    /// With [`LeverArm::Undeformed`] the power misses that of the moment Ψ q × f̄, see [`LeverArm`].
    /// Shape: N = 6 + M. Units: N, N m, N m per unit modal coordinate. Frame: body.
    /// Source: (199)-(201), with or without P_fr. Panics: never (N is checked when compiling).
    pub fn force_about<const N: usize>(
        &self,
        q: &SVector<T, M>,
        force: &Vector3<T>,
        lever_arm: LeverArm,
    ) -> SVector<T, N> {
        generalised_force(*force, self.lever_arm(q, lever_arm).cross(force), &self.translation, force)
    }

    /// Jacobian C of the marker's velocity in [v; ω; q̇]: [I, -l~, Ψ] with the lever arm l of choice.
    ///
    /// Row by row the marker's velocity, C [v; ω; q̇]; as a constraint its generalised force is Cᵀλ, which is
    /// [`force_about`](Self::force_about) of the multipliers λ with the same lever arm.
    /// Shape: 3 x N, N = 6 + M. Units: 1, m, m per unit modal coordinate. Frame: body.
    /// Source: (215), body-resolved, with or without C_bf P_fr. Panics: never (N is checked when compiling).
    pub fn velocity_jacobian<const N: usize>(
        &self,
        q: &SVector<T, M>,
        lever_arm: LeverArm,
    ) -> SMatrix<T, 3, N> {
        const { assert!(N == 6 + M, "a body with M modes has N = 6 + M velocities") };
        let mut jacobian = SMatrix::<T, 3, N>::zeros();
        let turned = -self.lever_arm(q, lever_arm).cross_matrix();
        for i in 0..3 {
            jacobian[(i, i)] = T::one();
            for j in 0..3 {
                jacobian[(i, 3 + j)] = turned[(i, j)];
            }
            for (mu, row) in self.translation.iter().enumerate() {
                jacobian[(i, 6 + mu)] = row[i];
            }
        }
        jacobian
    }

    /// Jacobian of the marker's position p + A (x + Ψ q) in [p; θ; q]: [I, -A l~ Ḡ, A Ψ] with the lever arm l of choice.
    ///
    /// θ has unit norm, so no derivative along θ is in it (Ḡ θ = 0). As a constraint its generalised force is Cᵀλ.
    /// Shape: 3 x P, P = 7 + M, θ scalar first. Units: 1, m, m per unit modal coordinate. Frame: inertial.
    /// Source: (215) with or without C_bf P_fr. Panics: never (P is checked when compiling).
    pub fn position_jacobian<const P: usize>(
        &self,
        orientation: &UnitQuaternion<T>,
        q: &SVector<T, M>,
        lever_arm: LeverArm,
    ) -> SMatrix<T, 3, P> {
        const { assert!(P == 7 + M, "a body with M modes has P = 7 + M coordinates with Euler parameters") };
        let mut jacobian = SMatrix::<T, 3, P>::zeros();
        let rotation = orientation.to_rotation_matrix();
        let turned = rotation.matrix()
            * -self.lever_arm(q, lever_arm).cross_matrix()
            * angular_velocity_matrix(orientation);
        jacobian.fixed_view_mut::<3, 3>(0, 0).fill_with_identity();
        jacobian.fixed_view_mut::<3, 4>(0, 3).copy_from(&turned);
        for (mu, row) in self.translation.iter().enumerate() {
            jacobian.set_column(7 + mu, &(rotation.matrix() * Vector3::from(*row)));
        }
        jacobian
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
