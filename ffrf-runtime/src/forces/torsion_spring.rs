//! A linear spring and damper about the axis of a joint.

use nalgebra::{RealField, Vector3};

use super::{ForceElement, SoftRow};
use crate::body::{MarkerMotion, MarkerStep, Wrench};

/// A spring with a damper about the z axis of the first triad, for joints that keep both z axes together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionSpring<T = f64> {
    /// Units: N m/rad.
    pub stiffness: T,
    /// Units: N m s/rad.
    pub damping: T,
    /// Angle without moment, within half a turn. Units: rad.
    pub rest_angle: T,
}

impl<T: RealField + Copy> ForceElement<T> for TorsionSpring<T> {
    /// Wrenches on both ends (inertial).
    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2] {
        let axis = first.orientation.transform_vector(&Vector3::z());
        let rate = axis.dot(&(second.angular_velocity - first.angular_velocity));
        let angle = self.turn(first, second);
        let moment = axis * (self.stiffness * angle + self.damping * rate);
        let force = Vector3::zeros();
        [Wrench { force, moment }, Wrench { force, moment: -moment }]
    }

    /// With s = y₁ · x₂ and c = x₁ · x₂ the angle changes by Δφ = atan2(N, D), N = c̄ Δs - s̄ Δc, D = c_0 c_1 + s_0 s_1, and Δs
    /// and Δc by the rotation vectors of both ends exactly: so the work is that of the change of the energy.
    fn wrenches_over(&self, first: &MarkerStep<T>, second: &MarkerStep<T>) -> [Wrench<T>; 2] {
        let half: T = nalgebra::convert(0.5);
        let places = [0, 1].map(|k| {
            let (one, other) = (first.ends[k].axes(), second.ends[k].axes());
            [one.column(1).dot(&other.column(0)), one.column(0).dot(&other.column(0))]
        });
        let [[s_0, c_0], [s_1, c_1]] = places;
        let (numerator, denominator) = (s_1 * c_0 - s_0 * c_1, c_0 * c_1 + s_0 * s_1);
        let turned = numerator.atan2(denominator);
        let ratio = if numerator == T::zero() { T::one() / denominator } else { turned / numerator };
        let angle = self.turn(&first.ends[0], &second.ends[0]) + turned * half;
        let (one, other) = (first.mean.axes(), second.mean.axes());
        let (x, y, axis): (Vector3<T>, Vector3<T>, Vector3<T>) =
            (one.column(0).into(), one.column(1).into(), one.column(2).into());
        let pointer: Vector3<T> = other.column(0).into();
        let (s, c) = ((s_0 + s_1) * half, (c_0 + c_1) * half);
        let gradient = pointer.cross(&(y * c - x * s)) * ratio;
        let rate = axis.dot(&(second.mean.angular_velocity - first.mean.angular_velocity));
        let moment = gradient * (self.stiffness * angle) + axis * (self.damping * rate);
        let force = Vector3::zeros();
        [Wrench { force, moment }, Wrench { force, moment: -moment }]
    }

    /// One: about the axis.
    fn soften(&self, first: &MarkerMotion<T>, _second: &MarkerMotion<T>, push: &mut dyn FnMut(SoftRow<T>)) {
        let axis = first.orientation.transform_vector(&Vector3::z());
        let force = Vector3::zeros();
        push(SoftRow {
            first: Wrench { force, moment: -axis },
            second: Wrench { force, moment: axis },
            stiffness: self.stiffness,
            damping: self.damping,
        });
    }

    /// Stored energy. Units: J.
    fn energy(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let angle = self.turn(first, second);
        self.stiffness * angle * angle * nalgebra::convert(0.5)
    }
}

impl<T: RealField + Copy> TorsionSpring<T> {
    /// The angle from rest, within half a turn.
    fn turn(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let angle = relative_angle(first, second) - self.rest_angle;
        let (turn, half) = (T::two_pi(), T::pi());
        if angle > half {
            angle - turn
        } else if angle < -half {
            angle + turn
        } else {
            angle
        }
    }
}

/// The angle from x₁ to x₂ about z₁, within half a turn. Units: rad.
pub fn relative_angle<T: RealField + Copy>(first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
    let direction = second.orientation.transform_vector(&Vector3::x());
    let x = first.orientation.transform_vector(&Vector3::x());
    let y = first.orientation.transform_vector(&Vector3::y());
    y.dot(&direction).atan2(x.dot(&direction))
}
