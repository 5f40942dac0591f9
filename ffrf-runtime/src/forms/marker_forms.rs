//! Forces and Jacobians of markers in the paper's forms, with its choice of lever arm.

use nalgebra::{RealField, SMatrix, SVector, UnitQuaternion, Vector3};

use super::{LeverArm, angular_velocity_matrix};
use crate::{GeneralisedForce, Marker};

/// The position that forces and constraints turn the body about: x + Ψ q, or x alone. Shape: 3. Units: m. Frame: body.
fn lever_arm<const M: usize, T: RealField + Copy>(
    marker: &Marker<SVector<T, M>, T>,
    q: &SVector<T, M>,
    lever_arm: LeverArm,
) -> Vector3<T> {
    match lever_arm {
        LeverArm::Deformed => marker.position(q),
        LeverArm::Undeformed => marker.position,
    }
}

/// Generalised force of a force f̄ at a marker about the lever arm of choice: [f̄; l × f̄; φ_μ · f̄].
///
/// With [`LeverArm::Undeformed`] the power misses that of the moment Ψ q × f̄, see [`LeverArm`].
/// Shape: N = 6 + M. Frame: body. Source: (199)-(201), with or without P_fr.
pub fn force_about<const M: usize, const N: usize, T: RealField + Copy>(
    marker: &Marker<SVector<T, M>, T>,
    q: &SVector<T, M>,
    force: &Vector3<T>,
    arm: LeverArm,
) -> SVector<T, N> {
    let moment = lever_arm(marker, q, arm).cross(force);
    let modal = marker.force(q, force).modal;
    GeneralisedForce { force: *force, moment, modal }.to_vector()
}

/// Jacobian C of a marker's velocity in [v; ω; q̇]: [I, -l~, Ψ] with the lever arm l of choice.
///
/// Row by row the marker's velocity, C [v; ω; q̇]; as a constraint its generalised force is Cᵀλ, which is
/// [`force_about`] of the multipliers λ with the same lever arm.
/// Shape: 3 x N, N = 6 + M. Units: 1, m, m per unit modal coordinate. Frame: body.
/// Source: (215), body-resolved, with or without C_bf P_fr.
pub fn marker_velocity_jacobian<const M: usize, const N: usize, T: RealField + Copy>(
    marker: &Marker<SVector<T, M>, T>,
    q: &SVector<T, M>,
    arm: LeverArm,
) -> SMatrix<T, 3, N> {
    let mut jacobian = SMatrix::<T, 3, N>::zeros();
    for (axis, mut row) in jacobian.row_iter_mut().enumerate() {
        let mut unit = Vector3::zeros();
        unit[axis] = T::one();
        row.copy_from(&force_about::<M, N, T>(marker, q, &unit, arm).transpose());
    }
    jacobian
}

/// Jacobian of a marker's position p + A (x + Ψ q) in [p; θ; q]: [I, -A l~ Ḡ, A Ψ] with the lever arm l of choice.
///
/// θ has unit norm, so no derivative along θ is in it (Ḡ θ = 0). As a constraint its generalised force is Cᵀλ.
/// Shape: 3 x P, P = 7 + M, θ scalar first. Units: 1, m, m per unit modal coordinate. Frame: inertial.
/// Source: (215) with or without C_bf P_fr.
pub fn marker_position_jacobian<const M: usize, const P: usize, T: RealField + Copy>(
    marker: &Marker<SVector<T, M>, T>,
    orientation: &UnitQuaternion<T>,
    q: &SVector<T, M>,
    arm: LeverArm,
) -> SMatrix<T, 3, P> {
    const { assert!(P == 7 + M, "a body with M modes has P = 7 + M coordinates with Euler parameters") };
    let mut jacobian = SMatrix::<T, 3, P>::zeros();
    let rotation = orientation.to_rotation_matrix();
    let turned =
        rotation.matrix() * -lever_arm(marker, q, arm).cross_matrix() * angular_velocity_matrix(orientation);
    jacobian.fixed_view_mut::<3, 3>(0, 0).fill_with_identity();
    jacobian.fixed_view_mut::<3, 4>(0, 3).copy_from(&turned);
    for mu in 0..M {
        let [x, y, z] = &marker.translation;
        jacobian.set_column(7 + mu, &(rotation.matrix() * Vector3::new(x[mu], y[mu], z[mu])));
    }
    jacobian
}
