//! The inertial form (203): translation and rotation in inertial components.

use nalgebra::{RealField, SMatrix, SVector, UnitQuaternion};

/// The equations of motion in inertial components, M y + Q + [0; 0; K q + D q̇] = [F; moment; f].
///
/// Unknowns y = [p̈; d(A ω)/dt; q̈]. With A, the rotation matrix: M = R M_body Rᵀ and Q = R Q_body, where
/// R = diag(A, A, I); in particular M_tr = -m A r~ Aᵀ (printed with the wrong sign).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InertialForm<const N: usize, T = f64> {
    /// Mass matrix. Shape: N x N, symmetric. Frame: inertial. Source: (203), corrected.
    pub mass_matrix: SMatrix<T, N, N>,
    /// Quadratic velocity vector, on the left-hand side. Shape: N. Frame: inertial. Source: (203), (209), corrected.
    pub quadratic_velocity: SVector<T, N>,
}

impl<const N: usize, T: RealField + Copy> InertialForm<N, T> {
    /// Rotates the body-resolved mass matrix and quadratic velocity vector. Panics: never.
    pub fn new(
        orientation: &UnitQuaternion<T>,
        mass_matrix: &SMatrix<T, N, N>,
        quadratic_velocity: &SVector<T, N>,
    ) -> Self {
        let columns = rotate_rows(orientation, mass_matrix);
        Self {
            mass_matrix: rotate_rows(orientation, &columns.transpose()),
            quadratic_velocity: to_inertial(orientation, quadratic_velocity),
        }
    }
}

/// R X: each column of X rotated as by [`to_inertial`].
fn rotate_rows<const N: usize, T: RealField + Copy>(
    orientation: &UnitQuaternion<T>,
    matrix: &SMatrix<T, N, N>,
) -> SMatrix<T, N, N> {
    let mut result = *matrix;
    for (mut rotated, column) in result.column_iter_mut().zip(matrix.column_iter()) {
        rotated.copy_from(&to_inertial(orientation, &column.into_owned()));
    }
    result
}

/// [A a; A b; c] of [a; b; c]: accelerations or forces from the body frame to the inertial frame.
///
/// Shape: N = 6 + M. Panics: never.
pub fn to_inertial<const N: usize, T: RealField + Copy>(
    orientation: &UnitQuaternion<T>,
    body: &SVector<T, N>,
) -> SVector<T, N> {
    const { assert!(N >= 6, "a body has at least six velocities") };
    let mut result = *body;
    for start in [0, 3] {
        let rotated = orientation * body.fixed_rows::<3>(start);
        result.fixed_rows_mut::<3>(start).copy_from(&rotated);
    }
    result
}

/// [Aᵀa; Aᵀb; c] of [a; b; c]: accelerations or forces from the inertial frame to the body frame.
///
/// Shape: N = 6 + M. Panics: never.
pub fn to_body<const N: usize, T: RealField + Copy>(
    orientation: &UnitQuaternion<T>,
    inertial: &SVector<T, N>,
) -> SVector<T, N> {
    to_inertial(&orientation.inverse(), inertial)
}
