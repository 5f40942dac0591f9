//! The motion of a marker as joints, forces and sensors see it: three-vectors in space, whatever the body.

use nalgebra::{Matrix3, RealField, UnitQuaternion, Vector3};

use super::marker::{SmallRotation, combine, transposed};
use super::{GeneralisedForce, Marker, ModalVector, Motion, State};
use crate::rotation::{cayley, matrix};

/// Place and motion of a marker; the velocities are the exact derivatives of the place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarkerMotion<T: RealField + Copy = f64> {
    /// Position. Shape: 3. Units: m. Frame: inertial.
    pub position: Vector3<T>,
    /// Orientation of the marker's triad: that of the body frame and the Cayley map of the small rotation.
    pub orientation: UnitQuaternion<T>,
    /// Means of the axes of the triad at both ends of a step, as columns, where this is the mean of a motion; they are no
    /// triad. Else the axes are those of [`orientation`](Self::orientation). Shape: 3 x 3. Units: 1. Frame: inertial.
    pub mean_axes: Option<Matrix3<T>>,
    /// Velocity. Shape: 3. Units: m/s. Frame: inertial.
    pub velocity: Vector3<T>,
    /// Angular velocity of the triad. Shape: 3. Units: rad/s. Frame: inertial.
    pub angular_velocity: Vector3<T>,
    /// The acceleration if all accelerations of the body were zero. Shape: 3. Units: m/s². Frame: inertial.
    pub acceleration_bias: Vector3<T>,
    /// The angular acceleration if all accelerations of the body were zero. Shape: 3. Units: rad/s². Frame: inertial.
    pub angular_acceleration_bias: Vector3<T>,
}

impl<T: RealField + Copy> MarkerMotion<T> {
    /// A place that never moves.
    pub fn fixed(position: Vector3<T>, orientation: UnitQuaternion<T>) -> Self {
        let zero = Vector3::zeros();
        Self {
            position,
            orientation,
            mean_axes: None,
            velocity: zero,
            angular_velocity: zero,
            acceleration_bias: zero,
            angular_acceleration_bias: zero,
        }
    }

    /// The axes of the triad as columns. Shape: 3 x 3. Units: 1. Frame: inertial.
    pub fn axes(&self) -> Matrix3<T> {
        self.mean_axes.unwrap_or_else(|| matrix(&self.orientation))
    }

    /// The same motion of a triad that is turned in this one.
    #[must_use]
    pub fn turned(mut self, orientation: &UnitQuaternion<T>) -> Self {
        self.turn(orientation);
        self
    }

    /// [`turned`](Self::turned) in place.
    #[inline]
    pub(crate) fn turn(&mut self, orientation: &UnitQuaternion<T>) {
        self.orientation *= *orientation;
        if let Some(axes) = &mut self.mean_axes {
            *axes *= matrix(orientation);
        }
    }
}

/// A force and a moment at a marker, or a row of a constraint: dual to the marker's velocities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrench<T = f64> {
    /// Force. Shape: 3. Units: N.
    pub force: Vector3<T>,
    /// Moment about the marker. Shape: 3. Units: N m.
    pub moment: Vector3<T>,
}

impl<T: RealField + Copy> Wrench<T> {
    /// No force, no moment.
    pub fn zero() -> Self {
        Self { force: Vector3::zeros(), moment: Vector3::zeros() }
    }

    /// The power in a motion of the marker, or the product of a gradient with velocities.
    pub fn power(&self, velocity: &Vector3<T>, angular_velocity: &Vector3<T>) -> T {
        self.force.dot(velocity) + self.moment.dot(angular_velocity)
    }
}

/// Sets the motion of a point of a body without modes. `arm`: from the frame origin, body frame.
// number by number: what is made elsewhere and copied in wider pieces waits for its stores
#[inline(always)]
pub(crate) fn move_rigidly<V, T: RealField + Copy>(
    motion: &mut MarkerMotion<T>,
    arm: &Vector3<T>,
    state: &State<V, T>,
    axes: &Matrix3<T>,
) {
    let omega = &state.angular_velocity;
    let carried = omega.cross(arm);
    motion.position = state.position + axes * arm;
    motion.orientation = state.orientation;
    motion.mean_axes = None;
    motion.velocity = state.velocity + axes * carried;
    motion.angular_velocity = axes * omega;
    motion.acceleration_bias = axes * omega.cross(&carried);
    motion.angular_acceleration_bias = Vector3::zeros();
}

/// A marker in a state: the lever arm and the rotation are found once for all that needs them.
#[derive(Debug, Clone, Copy)]
pub struct PlacedMarker<'a, V, T: RealField + Copy> {
    pub(super) marker: &'a Marker<V, T>,
    pub(super) orientation: UnitQuaternion<T>,
    /// The axes of the body as columns. Frame: inertial.
    pub(super) axes: Matrix3<T>,
    /// x + Ψ q, body frame.
    pub(super) arm: Vector3<T>,
    pub(super) rotation: SmallRotation<T>,
}

impl<'a, V: ModalVector<T>, T: RealField + Copy> PlacedMarker<'a, V, T> {
    /// `marker` of a body in `state`.
    pub fn new(marker: &'a Marker<V, T>, state: &State<V, T>) -> Self {
        Self::with_axes(marker, state, &matrix(&state.orientation))
    }

    /// [`new`](Self::new) with the axes of the body, which belong to its orientation.
    #[inline]
    pub(crate) fn with_axes(marker: &'a Marker<V, T>, state: &State<V, T>, axes: &Matrix3<T>) -> Self {
        Self {
            marker,
            orientation: state.orientation,
            axes: *axes,
            arm: marker.position(&state.modal_coordinates),
            rotation: SmallRotation::new(marker.small_rotation(&state.modal_coordinates)),
        }
    }

    /// From the frame origin to the marker. Shape: 3. Units: m. Frame: body.
    #[inline]
    pub(crate) fn arm(&self) -> Vector3<T> {
        self.arm
    }

    /// Place, velocities and acceleration biases. Source: derivatives of p + A (x + Ψ q) and of the triad.
    pub fn motion(&self, state: &State<V, T>) -> MarkerMotion<T> {
        if state.modal_rates.as_slice().is_empty() {
            let mut motion = MarkerMotion::fixed(state.position, state.orientation);
            move_rigidly(&mut motion, &self.arm, state, &self.axes);
            return motion;
        }
        let two: T = nalgebra::convert(2.0);
        let omega = &state.angular_velocity;
        let (arm, shift) = (self.arm, combine(&self.marker.translation, &state.modal_rates));
        let turning = combine(&self.marker.rotation, &state.modal_rates);
        let spin = self.rotation.times(&turning);
        let carried = omega.cross(&arm) + shift;
        let centripetal = omega.cross(&(carried + shift));
        // d/dt W ϑ̇ at ϑ̈ = 0: -(ϑ/2 · ϑ̇) / (1 + |ϑ|²/4) times W ϑ̇, and the turning of the body frame
        let slowing = self.rotation.half.dot(&turning) * self.rotation.share;
        let gyration = omega.cross(&spin) - spin * slowing;
        let inertial = |vector: &Vector3<T>| self.axes * vector;
        MarkerMotion {
            position: state.position + inertial(&arm),
            orientation: self.orientation * cayley(&(self.rotation.half * two)),
            mean_axes: None,
            velocity: state.velocity + inertial(&carried),
            angular_velocity: inertial(&(omega + spin)),
            acceleration_bias: inertial(&centripetal),
            angular_acceleration_bias: inertial(&gyration),
        }
    }

    /// The marker's velocities [v; ω] (inertial) of velocities or accelerations of the body, without bias.
    pub fn twist(&self, motion: &Motion<V, T>) -> [Vector3<T>; 2] {
        let linear = motion.linear
            + motion.angular.cross(&self.arm)
            + combine(&self.marker.translation, &motion.modal);
        let angular = motion.angular + self.rotation.times(&combine(&self.marker.rotation, &motion.modal));
        [self.axes * linear, self.axes * angular]
    }

    /// Generalised force of an inertial wrench at the marker: the transpose of [`twist`](Self::twist).
    pub fn generalised_force(&self, wrench: &Wrench<T>) -> GeneralisedForce<V, T> {
        let force = self.axes.tr_mul(&wrench.force);
        let moment = self.axes.tr_mul(&wrench.moment);
        let mut modal = transposed(&self.marker.translation, &force);
        let turned = self.rotation.transposed_times(&moment);
        for (row, component) in self.marker.rotation.iter().zip(turned.iter()) {
            modal.add_scaled(*component, row);
        }
        GeneralisedForce { force, moment: self.arm.cross(&force) + moment, modal }
    }
}
