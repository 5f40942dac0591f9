//! Constraint rows at a marker: what all rows of a joint do to a body, side by side.

use nalgebra::{RealField, Vector3};

use super::{ModalVector, PlacedMarker};
use crate::six::{Square, add_scaled, scaled, subtract_scaled};

impl<V: ModalVector<T>, T: RealField + Copy> PlacedMarker<'_, V, T> {
    /// [`generalised_force`](Self::generalised_force) of six wrenches at once.
    ///
    /// `wrenches`: components x, y, z of their forces and moments. Shape: 6 x 6. Frame: inertial. Sets the components of
    /// force and moment on the frame, and those on the modes. Shape: 6 x 6, M x 6. Frame: body.
    pub(crate) fn generalised_forces(
        &self,
        wrenches: &Square<T>,
        rigid: &mut Square<T>,
        modal: &mut [[T; 6]],
    ) {
        let [x, y, z, r_x, r_y, r_z] = wrenches;
        let force = self.rows_to_body([x, y, z]);
        let moment = self.rows_to_body([r_x, r_y, r_z]);
        if !modal.is_empty() {
            let turned = self.rotation.transposed_times_rows(&moment);
            let [x, y, z] = self.marker.translation.each_ref().map(V::as_slice);
            let [r_x, r_y, r_z] = self.marker.rotation.each_ref().map(V::as_slice);
            let (translations, rotations) = (x.iter().zip(y).zip(z), r_x.iter().zip(r_y).zip(r_z));
            for ((place, ((x, y), z)), ((r_x, r_y), r_z)) in modal.iter_mut().zip(translations).zip(rotations)
            {
                let mut sum = scaled(*x, &force[0]);
                add_scaled(&mut sum, *y, &force[1]);
                add_scaled(&mut sum, *z, &force[2]);
                add_scaled(&mut sum, *r_x, &turned[0]);
                add_scaled(&mut sum, *r_y, &turned[1]);
                add_scaled(&mut sum, *r_z, &turned[2]);
                *place = sum;
            }
        }
        // row by row where they stay
        let [x, y, z, about_x, about_y, about_z] = rigid;
        [*x, *y, *z] = force;
        let arm = &self.arm;
        let about = |place: &mut [T; 6], own: &[T; 6], more: (T, &[T; 6]), less: (T, &[T; 6])| {
            let mut sum = *own;
            add_scaled(&mut sum, more.0, more.1);
            subtract_scaled(&mut sum, less.0, less.1);
            *place = sum;
        };
        about(about_x, &moment[0], (arm.y, z), (arm.z, y));
        about(about_y, &moment[1], (arm.z, x), (arm.x, z));
        about(about_z, &moment[2], (arm.x, y), (arm.y, x));
    }

    /// The velocities [v; ω] (inertial) of a point that is carried by the marker, `beyond` (inertial) from it, for a unit rate of
    /// each mode. Shape: M x 6.
    pub(crate) fn modal_twists(&self, beyond: &Vector3<T>, twists: &mut [[T; 6]]) {
        if twists.is_empty() {
            return;
        }
        let none = T::zero();
        let moved = [0, 1, 2].map(|axis| {
            let [x, y, z]: [T; 3] = self.axes.column(axis).into_owned().into();
            [x, y, z, none, none, none]
        });
        let turned = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| {
            let angular = self.axes * self.rotation.times(&axis);
            let linear = angular.cross(beyond);
            [linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]
        });
        let [x, y, z] = self.marker.translation.each_ref().map(V::as_slice);
        let [r_x, r_y, r_z] = self.marker.rotation.each_ref().map(V::as_slice);
        let (translations, rotations) = (x.iter().zip(y).zip(z), r_x.iter().zip(r_y).zip(r_z));
        for ((place, ((x, y), z)), ((r_x, r_y), r_z)) in twists.iter_mut().zip(translations).zip(rotations) {
            let mut sum = scaled(*x, &moved[0]);
            add_scaled(&mut sum, *y, &moved[1]);
            add_scaled(&mut sum, *z, &moved[2]);
            add_scaled(&mut sum, *r_x, &turned[0]);
            add_scaled(&mut sum, *r_y, &turned[1]);
            add_scaled(&mut sum, *r_z, &turned[2]);
            *place = sum;
        }
    }

    /// Components of six inertial vectors in the body frame.
    #[inline(always)]
    fn rows_to_body(&self, [x, y, z]: [&[T; 6]; 3]) -> [[T; 6]; 3] {
        let along = |[along_x, along_y, along_z]: &[T; 3]| {
            let mut sum = scaled(*along_x, x);
            add_scaled(&mut sum, *along_y, y);
            add_scaled(&mut sum, *along_z, z);
            sum
        };
        let [first, second, third] = &self.axes.data.0;
        [along(first), along(second), along(third)]
    }
}
