//! Motion and forces of one body in three named parts: linear, angular, modal.

use nalgebra::{RealField, SVector, Vector3};

use super::ModalVector;
use crate::math::array;

/// Velocities or accelerations of a body, or a small change of its place.
///
/// As accelerations: α = Aᵀp̈ of the frame origin, ω̇, q̈. As velocities: v = Aᵀṗ, ω, q̇. Frame: body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion<V, T = f64> {
    /// Of the frame origin. Shape: 3. Units: m/s² or m/s. Frame: body.
    pub linear: Vector3<T>,
    /// Of the body frame. Shape: 3. Units: rad/s² or rad/s. Frame: body.
    pub angular: Vector3<T>,
    /// Of the modal coordinates. Shape: M. Units: those of the modes, per s² or s.
    pub modal: V,
}

/// A generalised force on a body, dual to [`Motion`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeneralisedForce<V, T = f64> {
    /// Resultant force. Shape: 3. Units: N. Frame: body.
    pub force: Vector3<T>,
    /// Moment about the frame origin. Shape: 3. Units: N m. Frame: body.
    pub moment: Vector3<T>,
    /// Modal forces. Shape: M. Units: J per unit modal coordinate.
    pub modal: V,
}

macro_rules! three_parts {
    ($name:ident: $first:ident, $second:ident) => {
        impl<V: ModalVector<T>, T: RealField + Copy> $name<V, T> {
            /// Zero, with as many modes as `alike`.
            pub fn zeros(alike: &V) -> Self {
                Self { $first: Vector3::zeros(), $second: Vector3::zeros(), modal: alike.zeros_alike() }
            }

            /// Adds `factor * other`.
            #[inline]
            pub fn add_scaled(&mut self, factor: T, other: &Self) {
                self.$first += other.$first * factor;
                self.$second += other.$second * factor;
                self.modal.add_scaled(factor, &other.modal);
            }

            /// Multiplies every component by `factor`.
            #[inline]
            pub fn scale(&mut self, factor: T) {
                self.$first *= factor;
                self.$second *= factor;
                self.modal.scale(factor);
            }

            /// Whether every component is finite.
            pub fn is_finite(&self) -> bool {
                let rigid = self.$first.iter().chain(self.$second.iter());
                rigid.into_iter().all(|entry| entry.is_finite()) && self.modal.all_finite()
            }
        }

        impl<const M: usize, T: RealField + Copy> $name<SVector<T, M>, T> {
            /// The parts one below the other. Shape: N = 6 + M.
            #[inline(always)]
            pub fn to_vector<const N: usize>(&self) -> SVector<T, N> {
                const { assert!(N == 6 + M, "a body with M modes has N = 6 + M velocities") };
                let mut vector = [T::zero(); N];
                vector[..3].copy_from_slice(array(&self.$first));
                vector[3..6].copy_from_slice(array(&self.$second));
                vector[6..].copy_from_slice(array(&self.modal));
                crate::math::vector(vector)
            }

            /// The parts of a vector of N = 6 + M entries.
            #[inline(always)]
            pub fn from_vector<const N: usize>(vector: &SVector<T, N>) -> Self {
                const { assert!(N == 6 + M, "a body with M modes has N = 6 + M velocities") };
                Self { $first: part(vector, 0), $second: part(vector, 3), modal: part(vector, 6) }
            }
        }
    };
}

three_parts!(Motion: linear, angular);
three_parts!(GeneralisedForce: force, moment);

impl<V: ModalVector<T>, T: RealField + Copy> GeneralisedForce<V, T> {
    /// The power of this force in a motion of velocities. Units: W.
    pub fn power(&self, velocities: &Motion<V, T>) -> T {
        self.force.dot(&velocities.linear)
            + self.moment.dot(&velocities.angular)
            + self.modal.dot(&velocities.modal)
    }
}

/// The `K` entries of a vector from `start` on, which it has.
#[inline(always)]
fn part<const K: usize, const N: usize, T: RealField + Copy>(
    vector: &SVector<T, N>,
    start: usize,
) -> SVector<T, K> {
    let mut part = [T::zero(); K];
    part.copy_from_slice(&array(vector)[start..start + K]);
    crate::math::vector(part)
}
