//! A body with all that hangs on it, as the joint that holds it meets it.

use nalgebra::{Matrix3, RealField, Vector3};

use crate::six::{Square, add, add_moment, add_scaled, zeros};

/// An end of a joint on a body of a tree.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LimbEnd<T> {
    /// Which of the ends of joints on the body this is.
    pub slot: usize,
    /// The marker.
    pub marker: usize,
    /// From the marker to where the joint's rows act, carried by the marker. Shape: 3. Units: m. Frame: inertial.
    pub beyond: Vector3<T>,
}

/// Where a body is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Seat {
    /// The slot of its own end of the joint.
    pub(crate) root: Option<usize>,
    /// What holds it, if that is no ground.
    pub(crate) parent: Option<Parent>,
}

/// What holds a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Parent {
    /// Among the branches.
    pub(crate) place: usize,
    pub(crate) body: usize,
    /// The slot of its end of the joint.
    pub(crate) slot: usize,
}

/// A body with all that hangs on it: A t - h = w at the end of the joint that holds it. Frame: inertial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limb<T: RealField + Copy = f64> {
    /// Where it is held.
    pub(crate) seat: Seat,
    /// A, of which the motions that the joint leaves are then taken out. Shape: 6 x 6, symmetric.
    pub(crate) inertia: Square<T>,
    /// h, likewise. Shape: 6.
    pub(crate) force: [T; 6],
    /// The axes of the body as columns when this was made: corrections that follow move bodies in these.
    pub(crate) axes: Matrix3<T>,
    /// From the origin of the body's frame to the end of the joint. Units: m.
    pub(crate) root: Vector3<T>,
    /// From the end of the parent's joint to that of this one. Units: m.
    pub(crate) arm: Vector3<T>,
    /// Whether modes bear what hangs on it.
    pub(crate) has_modes: bool,
    /// Whether its first three rows are the inertial axes: they hold a point.
    pub(crate) holds_point: bool,
    /// Duals of the rows: of translations, if they hold no point, and of rotations.
    pub(crate) held: [[Vector3<T>; 3]; 2],
    /// δ. Shape: 6.
    pub(crate) step: [T; 6],
    /// t; then the motion of the frame there, without what modes add. Shape: 6.
    pub(crate) twist: [T; 6],
}

impl<T: RealField + Copy> Limb<T> {
    /// Nothing that is held at its frame origin.
    pub(crate) fn empty() -> Self {
        let none = Vector3::zeros();
        Self {
            seat: Seat { root: None, parent: None },
            inertia: zeros(),
            force: [T::zero(); 6],
            axes: Matrix3::identity(),
            root: none,
            arm: none,
            has_modes: false,
            holds_point: false,
            held: [[none; 3]; 2],
            step: [T::zero(); 6],
            twist: [T::zero(); 6],
        }
    }

    /// Sets the inertia of a rigid body: mass, and first moment and inertia about the frame origin in axes that lie so.
    #[inline]
    pub(crate) fn set_rigid(
        &mut self,
        mass: T,
        first_moment: &Vector3<T>,
        inertia: &Matrix3<T>,
        axes: &Matrix3<T>,
    ) {
        self.axes = *axes;
        let (m, o, p) = (mass, T::zero(), &self.root);
        let about_origin = axes * first_moment;
        let turned = axes * inertia;
        let along = |i: usize, j: usize| {
            turned[(i, 0)] * axes[(j, 0)] + turned[(i, 1)] * axes[(j, 1)] + turned[(i, 2)] * axes[(j, 2)]
        };
        // J + b pᵀ + p bᵀ - m p pᵀ - (2 b · p - m p · p) I = J + b pᵀ + p (b - m p)ᵀ - ((2 b - m p) · p) I
        let b = about_origin - p * m;
        let less = (about_origin + b).dot(p);
        let moved = |i: usize, j: usize| along(i, j) + about_origin[i] * p[j] + p[i] * b[j];
        let (xx, yy, zz) = (moved(0, 0) - less, moved(1, 1) - less, moved(2, 2) - less);
        let (xy, xz, yz) = (moved(0, 1), moved(0, 2), moved(1, 2));
        let [x, y, z]: [T; 3] = b.into();
        self.inertia = [
            [m, o, o, o, z, -y],
            [o, m, o, -z, o, x],
            [o, o, m, y, -x, o],
            [o, -z, y, xx, xy, xz],
            [z, o, -x, xy, yy, yz],
            [-y, x, o, xz, yz, zz],
        ];
    }

    /// A force and moment about the frame origin, in axes that lie so, as force and moment about the root.
    #[inline]
    pub(crate) fn at_root(&self, axes: &Matrix3<T>, [x, y, z, r_x, r_y, r_z]: &[T; 6]) -> [T; 6] {
        let force = axes * Vector3::new(*x, *y, *z);
        let moment = axes * Vector3::new(*r_x, *r_y, *r_z) - self.root.cross(&force);
        [force.x, force.y, force.z, moment.x, moment.y, moment.z]
    }

    /// Sets the force: of what acts at the frame origin.
    #[inline]
    pub(crate) fn set_force(&mut self, force: &Vector3<T>, moment: &Vector3<T>) {
        let moment = moment - self.root.cross(force);
        self.force = [force.x, force.y, force.z, moment.x, moment.y, moment.z];
    }

    /// Acceleration of the frame origin, and angular acceleration. Frame: body.
    #[inline]
    pub(crate) fn frame_motion(&self) -> [Vector3<T>; 2] {
        let [x, y, z, r_x, r_y, r_z] = self.twist;
        let angular = Vector3::new(r_x, r_y, r_z);
        let linear = Vector3::new(x, y, z) - angular.cross(&self.root);
        [self.axes.tr_mul(&linear), self.axes.tr_mul(&angular)]
    }

    /// Adds what hangs on it at a point, `arm` from the end of its joint.
    #[inline]
    pub(crate) fn bear(&mut self, inertia: &Square<T>, arm: &Vector3<T>) {
        let [x, y, z] = [arm.x, arm.y, arm.z];
        // moments about the end of the joint, row by row, then the same in the columns
        let mut moved = *inertia;
        let about = |row: &mut [T; 6], more: (T, &[T; 6]), less: (T, &[T; 6])| {
            add_scaled(row, more.0, more.1);
            add_scaled(row, -less.0, less.1);
        };
        let [along_x, along_y, along_z, about_x, about_y, about_z] = &mut moved;
        about(about_x, (y, along_z), (z, along_y));
        about(about_y, (z, along_x), (x, along_z));
        about(about_z, (x, along_y), (y, along_x));
        for (place, row) in self.inertia.iter_mut().zip(&mut moved) {
            add_moment(row, arm);
            add(place, row);
        }
    }

    /// Adds a force at a point, `arm` from the end of its joint.
    #[inline]
    pub(crate) fn push(&mut self, mut force: [T; 6], arm: &Vector3<T>) {
        add_moment(&mut force, arm);
        add(&mut self.force, &force);
    }

    /// The acceleration at a point, `arm` from the end of its joint.
    #[inline]
    pub(crate) fn twist_at(&self, arm: &Vector3<T>) -> [T; 6] {
        let [x, y, z, r_x, r_y, r_z] = self.twist;
        [
            x + (r_y * arm.z - r_z * arm.y),
            y + (r_z * arm.x - r_x * arm.z),
            z + (r_x * arm.y - r_y * arm.x),
            r_x,
            r_y,
            r_z,
        ]
    }

    /// A times a motion.
    #[inline]
    pub(crate) fn resist(&self, motion: &[T; 6]) -> [T; 6] {
        let mut sum = [T::zero(); 6];
        for (row, amount) in self.inertia.iter().zip(motion) {
            add_scaled(&mut sum, *amount, row);
        }
        sum
    }
}
