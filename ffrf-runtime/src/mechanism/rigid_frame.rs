//! The motion of a rigid body in components in which its mass matrix is diagonal.

use nalgebra::{Matrix6, RealField, Vector3};

use crate::six::{Square, add_scaled, subtract_scaled};

/// Components of the motion of a rigid body: the acceleration of its centre of mass, and Lᵀ ω̇ with J = L D Lᵀ there.
///
/// The mass matrix is then diag(m, m, m, D): nothing is to be factored. All resolved in the body frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidFrame<T> {
    /// From the frame origin to the centre of mass. Units: m.
    center: Vector3<T>,
    /// L below its diagonal of ones: entries 21, 31, 32.
    lower: [T; 3],
    /// The diagonal of the mass matrix.
    masses: [T; 6],
}

impl<T: RealField + Copy> RigidFrame<T> {
    /// From the mass matrix about the frame origin. Not finite if the body has no mass.
    pub(super) fn new(mass_matrix: &Matrix6<T>) -> Self {
        let mass = mass_matrix.m11;
        // m r~ stands in the lower left, the inertia about the origin in the lower right
        let moment = Vector3::new(mass_matrix.m62, mass_matrix.m43, mass_matrix.m51);
        let center = moment / mass;
        let square = center.dot(&moment);
        let about = |i: usize, j: usize| center[i] * moment[j];
        let (xx, yy, zz) = (
            mass_matrix.m44 - (square - about(0, 0)),
            mass_matrix.m55 - (square - about(1, 1)),
            mass_matrix.m66 - (square - about(2, 2)),
        );
        let (yx, zx, zy) =
            (mass_matrix.m54 + about(1, 0), mass_matrix.m64 + about(2, 0), mass_matrix.m65 + about(2, 1));
        let (l21, l31) = (yx / xx, zx / xx);
        let d2 = yy - l21 * yx;
        let left = zy - l31 * yx;
        let l32 = left / d2;
        let d3 = zz - l31 * zx - l32 * left;
        Self { center, lower: [l21, l31, l32], masses: [mass, mass, mass, xx, d2, d3] }
    }

    /// The diagonal of the mass matrix.
    pub(super) fn masses(&self) -> &[T; 6] {
        &self.masses
    }

    /// Takes the effects of rows on forces and moments about the frame origin to these components.
    #[inline]
    pub(super) fn to_components(self, effects: &mut Square<T>) {
        let (center, [l21, l31, l32]) = (&self.center, self.lower);
        let [x, y, z, about_x, about_y, about_z] = effects;
        // less center × force
        subtract_scaled(about_x, center.y, z);
        add_scaled(about_x, center.z, y);
        subtract_scaled(about_y, center.z, x);
        add_scaled(about_y, center.x, z);
        subtract_scaled(about_z, center.x, y);
        add_scaled(about_z, center.y, x);
        subtract_scaled(about_y, l21, about_x);
        subtract_scaled(about_z, l31, about_x);
        subtract_scaled(about_z, l32, about_y);
    }

    /// The same of one force [force; moment about the frame origin].
    pub(super) fn force(&self, [x, y, z, r_x, r_y, r_z]: [T; 6]) -> [T; 6] {
        let [l21, l31, l32] = self.lower;
        let moment = Vector3::new(r_x, r_y, r_z) - self.center.cross(&Vector3::new(x, y, z));
        let second = moment.y - l21 * moment.x;
        [x, y, z, moment.x, second, moment.z - l31 * moment.x - l32 * second]
    }

    /// [acceleration of the frame origin; ω̇] of these components.
    pub(super) fn motion(&self, [x, y, z, first, second, third]: &[T; 6]) -> [T; 6] {
        let [l21, l31, l32] = self.lower;
        let about_y = *second - l32 * *third;
        let angular = Vector3::new(*first - l21 * about_y - l31 * *third, about_y, *third);
        let linear = Vector3::new(*x, *y, *z) - angular.cross(&self.center);
        [linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, SMatrix, SVector};

    use super::*;
    use crate::body::{FlexibleBody, RigidBody};

    /// Some ten operations on numbers of order one.
    const ROUND_OFF: f64 = 1e-14;

    /// The components are a change of basis T of motions: Tᵀ diag T is the mass matrix, effects and forces are its dual.
    #[test]
    fn the_mass_matrix_is_diagonal_in_these_components() {
        let inertia = Matrix3::new(2.0, 0.3, -0.2, 0.3, 1.5, 0.4, -0.2, 0.4, 2.5);
        let body = RigidBody::new(1.7, Vector3::new(0.4, -0.3, 0.6), inertia);
        let none = SVector::<f64, 0>::zeros();
        let mass_matrix = body.prepare(&none, &Vector3::zeros(), &none).rigid_mass();
        let frame = RigidFrame::new(&mass_matrix);
        let columns: [SVector<f64, 6>; 6] = core::array::from_fn(|k| {
            frame.motion(&core::array::from_fn(|i| if i == k { 1.0 } else { 0.0 })).into()
        });
        let basis = SMatrix::<f64, 6, 6>::from_columns(&columns);
        let diagonal = SMatrix::<f64, 6, 6>::from_diagonal(&SVector::from(*frame.masses()));
        assert!((basis.transpose() * mass_matrix * basis - diagonal).norm() < ROUND_OFF);
        let force = SVector::<f64, 6>::new(0.3, -0.7, 0.2, 0.5, 1.1, -0.4);
        let dual = basis.transpose() * force;
        assert!((SVector::from(frame.force(force.into())) - dual).norm() < ROUND_OFF);
        let mut effects = force.data.0[0].map(|entry| [entry, -entry, 2.0 * entry, 0.0, entry, entry]);
        frame.to_components(&mut effects);
        for (effect, dual) in effects.iter().zip(dual.iter()) {
            for (found, factor) in effect.iter().zip([1.0, -1.0, 2.0, 0.0, 1.0, 1.0]) {
                assert!((found - factor * dual).abs() < ROUND_OFF);
            }
        }
    }
}
