//! The motion of a rigid body in components in which its mass matrix is diagonal.

use nalgebra::{Matrix3, Matrix6, RealField, Vector3};

use crate::six::{Square, add_scaled, scaled, subtract_scaled};

/// Components of the motion of a rigid body: the acceleration of its centre of mass, and Lᵀ ω̇ with J = L D Lᵀ there.
///
/// The mass matrix is then diag(m, m, m, D): nothing is to be factored. The former is resolved along chosen axes: with the
/// inertial ones, force components of rows are effects as they are; the rest is resolved in the body frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidFrame<T> {
    /// The axes of the body as columns, in components of those along which linear motion is resolved.
    axes: Matrix3<T>,
    /// From the frame origin to the centre of mass. Units: m.
    center: Vector3<T>,
    /// L below its diagonal of ones: entries 21, 31, 32.
    lower: [T; 3],
    /// The diagonal of the mass matrix.
    masses: [T; 6],
}

impl<T: RealField + Copy> RigidFrame<T> {
    /// From the mass matrix about the frame origin, and the axes of the body. Not finite if the body has no mass.
    pub(super) fn new(mass_matrix: &Matrix6<T>, axes: &Matrix3<T>) -> Self {
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
        Self { axes: *axes, center, lower: [l21, l31, l32], masses: [mass, mass, mass, xx, d2, d3] }
    }

    /// The diagonal of the mass matrix.
    pub(super) fn masses(&self) -> &[T; 6] {
        &self.masses
    }

    /// From the centre of mass to a point of the body (body frame), along the axes of linear motion. Units: m.
    #[inline]
    pub(super) fn arm(&self, at: &Vector3<T>) -> Vector3<T> {
        self.axes * (at - self.center)
    }

    /// The components of a motion of a point of the body, `arm` from its centre of mass, along the axes of linear motion.
    #[inline]
    pub(super) fn components(&self, linear: &Vector3<T>, angular: &Vector3<T>, arm: &Vector3<T>) -> [T; 6] {
        let [l21, l31, l32] = self.lower;
        let center = linear - angular.cross(arm);
        let turned = self.axes.tr_mul(angular);
        [
            center.x,
            center.y,
            center.z,
            turned.x + l21 * turned.y + l31 * turned.z,
            turned.y + l32 * turned.z,
            turned.z,
        ]
    }

    /// The motion of a point of the body (body frame) in these components: [linear, angular], along the axes of linear motion.
    #[inline]
    pub(super) fn twist(&self, [x, y, z, first, second, third]: &[T; 6], at: &Vector3<T>) -> [Vector3<T>; 2] {
        let [l21, l31, l32] = self.lower;
        let about_y = *second - l32 * *third;
        let angular = self.axes * Vector3::new(*first - l21 * about_y - l31 * *third, about_y, *third);
        [Vector3::new(*x, *y, *z) + angular.cross(&self.arm(at)), angular]
    }

    /// The effects on these components of rows at a point of the body (body frame), with components of force and moment
    /// along the axes of linear motion. Shape: 6 x rows.
    #[inline]
    pub(super) fn effects(&self, at: &Vector3<T>, gradients: &Square<T>, effects: &mut Square<T>) {
        let arm = self.arm(at);
        let [x, y, z, r_x, r_y, r_z] = gradients;
        let moment = |own: &[T; 6], more: (T, &[T; 6]), less: (T, &[T; 6])| {
            let mut sum = *own;
            add_scaled(&mut sum, more.0, more.1);
            subtract_scaled(&mut sum, less.0, less.1);
            sum
        };
        // about the centre of mass, then in the body frame
        let about = [
            moment(r_x, (arm.y, z), (arm.z, y)),
            moment(r_y, (arm.z, x), (arm.x, z)),
            moment(r_z, (arm.x, y), (arm.y, x)),
        ];
        let along = |[along_x, along_y, along_z]: &[T; 3]| {
            let mut sum = scaled(*along_x, &about[0]);
            add_scaled(&mut sum, *along_y, &about[1]);
            add_scaled(&mut sum, *along_z, &about[2]);
            sum
        };
        let [first, second, third] = &self.axes.data.0;
        let [l21, l31, l32] = self.lower;
        let [to_x, to_y, to_z, about_x, about_y, about_z] = effects;
        [*to_x, *to_y, *to_z] = [*x, *y, *z];
        *about_x = along(first);
        let mut sum = along(second);
        subtract_scaled(&mut sum, l21, about_x);
        *about_y = sum;
        let mut sum = along(third);
        subtract_scaled(&mut sum, l31, about_x);
        subtract_scaled(&mut sum, l32, about_y);
        *about_z = sum;
    }

    /// Takes the effects of rows on forces and moments about the frame origin to these components, where linear motion is
    /// resolved along the axes of the body.
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

    /// One force [force; moment about the frame origin] (body frame) in these components.
    pub(super) fn force(&self, [x, y, z, r_x, r_y, r_z]: [T; 6]) -> [T; 6] {
        let [l21, l31, l32] = self.lower;
        let moment = Vector3::new(r_x, r_y, r_z) - self.center.cross(&Vector3::new(x, y, z));
        let second = moment.y - l21 * moment.x;
        let [x, y, z]: [T; 3] = (self.axes * Vector3::new(x, y, z)).into();
        [x, y, z, moment.x, second, moment.z - l31 * moment.x - l32 * second]
    }

    /// [acceleration of the frame origin; ω̇] (body frame) of these components.
    pub(super) fn motion(&self, [x, y, z, first, second, third]: &[T; 6]) -> [T; 6] {
        let [l21, l31, l32] = self.lower;
        let about_y = *second - l32 * *third;
        let angular = Vector3::new(*first - l21 * about_y - l31 * *third, about_y, *third);
        let linear = self.axes.tr_mul(&Vector3::new(*x, *y, *z)) - angular.cross(&self.center);
        [linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, UnitQuaternion};

    use super::*;
    use crate::body::{FlexibleBody, RigidBody};
    use crate::rotation::matrix;

    /// Some ten operations on numbers of order one.
    const ROUND_OFF: f64 = 1e-14;

    /// The components are a change of basis T of motions: Tᵀ diag T is the mass matrix, effects and forces are its dual.
    #[test]
    fn the_mass_matrix_is_diagonal_in_these_components() {
        let inertia = Matrix3::new(2.0, 0.3, -0.2, 0.3, 1.5, 0.4, -0.2, 0.4, 2.5);
        let body = RigidBody::new(1.7, Vector3::new(0.4, -0.3, 0.6), inertia);
        let none = SVector::<f64, 0>::zeros();
        let mass_matrix = body.prepare(&none, &Vector3::zeros(), &none).rigid_mass();
        let orientation = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.8, 0.5));
        for axes in [Matrix3::identity(), matrix(&orientation)] {
            check(&mass_matrix, &axes);
        }
    }

    fn check(mass_matrix: &SMatrix<f64, 6, 6>, axes: &Matrix3<f64>) {
        let frame = RigidFrame::new(mass_matrix, axes);
        let columns: [SVector<f64, 6>; 6] = core::array::from_fn(|k| {
            frame.motion(&core::array::from_fn(|i| if i == k { 1.0 } else { 0.0 })).into()
        });
        let basis = SMatrix::<f64, 6, 6>::from_columns(&columns);
        let diagonal = SMatrix::<f64, 6, 6>::from_diagonal(&SVector::from(*frame.masses()));
        assert!((basis.transpose() * mass_matrix * basis - diagonal).norm() < ROUND_OFF);
        let force = SVector::<f64, 6>::new(0.3, -0.7, 0.2, 0.5, 1.1, -0.4);
        let dual = basis.transpose() * force;
        assert!((SVector::from(frame.force(force.into())) - dual).norm() < ROUND_OFF);
        let six = |entry: f64| [entry, -entry, 2.0 * entry, 0.0, entry, entry];
        let agree = |effects: &Square<f64>| {
            for (effect, dual) in effects.iter().zip(dual.iter()) {
                for (found, expected) in effect.iter().zip(six(*dual)) {
                    assert!((found - expected).abs() < ROUND_OFF);
                }
            }
        };
        if *axes == Matrix3::identity() {
            let mut effects = force.data.0[0].map(six);
            frame.to_components(&mut effects);
            agree(&effects);
        }
        // the same force as one at another point
        let at = Vector3::new(-0.2, 0.7, 0.1);
        let (pull, moment) = (force.fixed_rows::<3>(0), force.fixed_rows::<3>(3));
        let (pull, moment) = (axes * pull, axes * (moment - at.cross(&pull.clone_owned())));
        let gradients = [pull.x, pull.y, pull.z, moment.x, moment.y, moment.z].map(six);
        let mut effects = crate::six::zeros();
        frame.effects(&at, &gradients, &mut effects);
        agree(&effects);
    }
}
