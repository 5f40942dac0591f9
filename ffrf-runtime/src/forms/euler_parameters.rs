//! The Euler-parameter form (214)-(217).

use nalgebra::{Matrix3, Quaternion, RealField, SMatrix, SVector, UnitQuaternion, Vector3, Vector4};

use crate::rotation::euler_parameters;

/// The equations of motion with Euler parameters, M y + [0; 0; K q + D q̇] + Cᵀλ = force + Q_v.
///
/// Unknowns y = [p̈; θ̈; q̈], P = 7 + M of them. The mass matrix has rank 6 + M: the normalisation
/// θ·θ̈ = -θ̇·θ̇, see [`normalisation`](Self::normalisation), supplies the missing equation. Its multiplier is zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerParameterForm<const P: usize, T = f64> {
    /// Mass matrix. Shape: P x P, symmetric, positive semidefinite. Source: (214), corrected.
    pub mass_matrix: SMatrix<T, P, P>,
    /// Quadratic velocity vector Q_v, on the *right-hand* side as in the paper. Shape: P. Source: (217), corrected.
    pub quadratic_velocity: SVector<T, P>,
}

impl<const P: usize, T: RealField + Copy> EulerParameterForm<P, T> {
    /// Transforms the body-resolved mass matrix and quadratic velocity vector.
    ///
    /// M = Zᵀ M_body Z and Q_v = -Zᵀ Q_body with Z = diag(Aᵀ, Ḡ, I). Panics: never.
    pub fn new<const N: usize>(
        orientation: &UnitQuaternion<T>,
        mass_matrix: &SMatrix<T, N, N>,
        quadratic_velocity: &SVector<T, N>,
    ) -> Self {
        let mut half = SMatrix::<T, P, N>::zeros();
        for (mut target, column) in half.column_iter_mut().zip(mass_matrix.column_iter()) {
            target.copy_from(&Self::force(orientation, &column.into_owned()));
        }
        let mut mass = SMatrix::<T, P, P>::zeros();
        for (mut target, row) in mass.column_iter_mut().zip(half.row_iter()) {
            target.copy_from(&Self::force(orientation, &row.transpose()));
        }
        Self { mass_matrix: mass, quadratic_velocity: -Self::force(orientation, quadratic_velocity) }
    }

    /// Zᵀ f: generalised forces [A f_t; Ḡᵀ τ; f_f] of the body-resolved [f_t; τ; f_f].
    ///
    /// Shape: P. Panics: never.
    pub fn force<const N: usize>(orientation: &UnitQuaternion<T>, body: &SVector<T, N>) -> SVector<T, P> {
        const { assert!(P == N + 1 && N >= 6, "Euler parameters are one more than angular velocities") };
        let torque: Vector3<T> = body.fixed_rows::<3>(3).into_owned();
        let mut result = SVector::<T, P>::zeros();
        result.fixed_rows_mut::<3>(0).copy_from(&(orientation * body.fixed_rows::<3>(0)));
        result.fixed_rows_mut::<4>(3).copy_from(&angular_velocity_matrix(orientation).tr_mul(&torque));
        for mu in 6..N {
            result[mu + 1] = body[mu];
        }
        result
    }

    /// A J Z: Jacobian in [p; θ; q], of an inertial vector, from the body-resolved Jacobian J in [v; ω; q̇].
    ///
    /// [`marker_position_jacobian`](super::marker_position_jacobian) is this of
    /// [`marker_velocity_jacobian`](super::marker_velocity_jacobian). Shape: 3 x P. Source: (215). Panics: never.
    pub fn jacobian<const N: usize>(
        orientation: &UnitQuaternion<T>,
        body: &SMatrix<T, 3, N>,
    ) -> SMatrix<T, 3, P> {
        let inertial = orientation.to_rotation_matrix().matrix() * body;
        let mut jacobian = SMatrix::<T, 3, P>::zeros();
        for (mut target, row) in jacobian.row_iter_mut().zip(inertial.row_iter()) {
            target.copy_from(&Self::force(orientation, &row.transpose()).transpose());
        }
        jacobian
    }

    /// y = [p̈; θ̈; q̈] of the body-resolved accelerations [Aᵀp̈; ω̇; q̈], with θ̈ = ¼ Ḡᵀ ω̇ - (θ̇·θ̇) θ.
    ///
    /// Shape: P. `rate` is θ̇. Panics: never.
    pub fn acceleration<const N: usize>(
        orientation: &UnitQuaternion<T>,
        rate: &Quaternion<T>,
        body: &SVector<T, N>,
    ) -> SVector<T, P> {
        let quarter: T = nalgebra::convert(0.25);
        let mut result = Self::force(orientation, body);
        let normal = Vector4::from(euler_parameters(orientation)) * rate.norm_squared();
        let tangent: Vector4<T> = result.fixed_rows::<4>(3) * quarter;
        result.fixed_rows_mut::<4>(3).copy_from(&(tangent - normal));
        result
    }

    /// The normalisation (216) twice differentiated: row C = θᵀ (on θ̈) and right-hand side -θ̇·θ̇.
    ///
    /// Shape: 4 and 1, scalar first. Panics: never.
    pub fn normalisation(orientation: &UnitQuaternion<T>, rate: &Quaternion<T>) -> (Vector4<T>, T) {
        (Vector4::from(euler_parameters(orientation)), -rate.norm_squared())
    }
}

/// Ḡ = 2 [-θ⃗, θ0 I - θ⃗~], so that ω = Ḡ θ̇ in the body frame.
///
/// Shape: 3 x 4, columns in the order [θ0, θ1, θ2, θ3]. Source: (212). Panics: never.
pub fn angular_velocity_matrix<T: RealField + Copy>(orientation: &UnitQuaternion<T>) -> SMatrix<T, 3, 4> {
    let vector = orientation.imag();
    let two: T = nalgebra::convert(2.0);
    let mut matrix = SMatrix::<T, 3, 4>::zeros();
    matrix.fixed_columns_mut::<1>(0).copy_from(&-vector);
    let right = Matrix3::from_diagonal_element(orientation.w) - vector.cross_matrix();
    matrix.fixed_columns_mut::<3>(1).copy_from(&right);
    matrix * two
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation::{angular_velocity, from_euler_parameters, quaternion_rate};

    #[test]
    fn the_matrix_of_212_gives_the_angular_velocity_and_that_of_213_the_rotation() {
        let orientation = from_euler_parameters([0.3, -0.5, 0.7, 0.1]).unwrap();
        let omega = Vector3::<f64>::new(1.0, -2.0, 0.5);
        let rate = quaternion_rate(&orientation, &omega);
        let body = angular_velocity_matrix(&orientation);
        let parameters = Vector4::new(rate.w, rate.i, rate.j, rate.k);
        assert!((body * parameters - angular_velocity(&orientation, &rate)).norm() < 1e-15);
        // (211): G = 2 [-θ⃗, θ0 I + θ⃗~], (213): A = ¼ G Ḡᵀ
        let conjugate = angular_velocity_matrix(&orientation.conjugate());
        let mut inertial = conjugate;
        inertial.fixed_columns_mut::<1>(0).neg_mut();
        let rotation = inertial * body.transpose() * 0.25;
        assert!((rotation - orientation.to_rotation_matrix().matrix()).norm() < 1e-15);
    }
}
