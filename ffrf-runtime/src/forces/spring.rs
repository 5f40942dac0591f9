//! A linear spring and damper between two points.

use nalgebra::{RealField, Vector3};

use super::{ForceElement, SoftRow};
use crate::body::{MarkerMotion, MarkerStep, Wrench};

/// A linear spring with a damper along the line between two points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring<T = f64> {
    /// Units: N/m.
    pub stiffness: T,
    /// Units: N s/m.
    pub damping: T,
    /// Length without force. Units: m.
    pub rest_length: T,
}

impl<T: RealField + Copy> ForceElement<T> for Spring<T> {
    /// Wrenches on both ends (inertial). Where the ends meet, the line has no direction and there is no force.
    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2] {
        let between = second.position - first.position;
        let length = between.norm();
        if length <= T::default_epsilon() {
            return [Wrench::zero(); 2];
        }
        let direction = between / length;
        let rate = direction.dot(&(second.velocity - first.velocity));
        let pull = direction * (self.stiffness * (length - self.rest_length) + self.damping * rate);
        let moment = Vector3::zeros();
        [Wrench { force: pull, moment }, Wrench { force: -pull, moment }]
    }

    /// With f = (k (l̄ - rest) + d l̇) (b_0 + b_1) / (l_0 + l_1), the work f · Δb is that of the change of the energy.
    fn wrenches_over(&self, first: &MarkerStep<T>, second: &MarkerStep<T>) -> [Wrench<T>; 2] {
        let [begin, end] = [0, 1].map(|k| (second.ends[k].position - first.ends[k].position).norm());
        let both = begin + end;
        if both <= T::default_epsilon() {
            return [Wrench::zero(); 2];
        }
        let (half, two): (T, T) = (nalgebra::convert(0.5), nalgebra::convert(2.0));
        let direction = (second.mean.position - first.mean.position) * (two / both);
        let rate = direction.dot(&(second.mean.velocity - first.mean.velocity));
        let pull = direction * (self.stiffness * (both * half - self.rest_length) + self.damping * rate);
        let moment = Vector3::zeros();
        [Wrench { force: pull, moment }, Wrench { force: -pull, moment }]
    }

    /// Three: along the line, and across it, where a stretched spring draws back by its force over its length. Where the ends
    /// meet, a spring without length pulls in every direction, and any other in none.
    fn soften(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>, push: &mut dyn FnMut(SoftRow<T>)) {
        let between = second.position - first.position;
        let length = between.norm();
        let apart = length > T::default_epsilon();
        let along = if apart { between / length } else { Vector3::z() };
        let least = along.iamin();
        let across = along.cross(&Vector3::ith(least, T::one())).normalize();
        let free = if self.rest_length > T::zero() { T::zero() } else { self.stiffness };
        let (along_line, across_line) = match apart {
            true => (self.stiffness, self.stiffness * (length - self.rest_length) / length),
            false => (free, free),
        };
        let damping = if apart { self.damping } else { T::zero() };
        let moment = Vector3::zeros();
        for (direction, stiffness, damping) in [
            (along, along_line, damping),
            (across, across_line, T::zero()),
            (along.cross(&across), across_line, T::zero()),
        ] {
            push(SoftRow {
                first: Wrench { force: -direction, moment },
                second: Wrench { force: direction, moment },
                stiffness,
                damping,
            });
        }
    }

    /// Stored energy. Units: J.
    fn energy(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        let stretch = (second.position - first.position).norm() - self.rest_length;
        self.stiffness * stretch * stretch * nalgebra::convert(0.5)
    }
}
