//! A rigid body that a joint holds on the ground: its unknowns are the motions that are left.
//!
//! With a the six components of its motion ([`RigidFrame`]), M their diagonal masses and E the effects of all rows on them, the r rows
//! of the joint leave
//!
//! ```text
//! a = a_0 + Σ s_k y_k,      k = 1 .. 6 - r
//! ```
//!
//! where a_0 takes what the joint asks for and the s_k span what it leaves, with s_jᵀ M s_k = 0 for j ≠ k. In place of a body with
//! six unknowns and a joint with r multipliers there are 6 - r unknowns of mass s_kᵀ M s_k, on which rows have the effects s_kᵀ E
//! and forces s_kᵀ (f - M a_0); rows see a_0 at their right-hand side. They stand in the last three places of the body's
//! node, of which the first ones are coupled to nothing; the joint has no block at all. Its multipliers are not found: where they are asked for,
//! the equations of all rows are solved.

use nalgebra::{RealField, Vector3};

use super::RigidFrame;
use super::tree::hold;
use crate::six::{Square, add_scaled, dot, products, scaled, subtract_scaled, zeros};

/// The most motions that a support leaves, and the first of their places.
const MOST_LEFT: usize = 3;

/// A joint with the ground, at its end on a body.
#[derive(Debug, Clone, Copy)]
pub struct Support<'r, T: RealField + Copy> {
    /// Which of the ends of joints on the body this is.
    pub(super) slot: usize,
    /// The marker there.
    pub(super) marker: usize,
    /// From the marker to where its rows act. Frame: inertial. Units: m.
    pub(super) beyond: Vector3<T>,
    /// Which way its rows count at the body.
    pub(super) sign: T,
    /// The rows at the joint's second end: components of force and moment, side by side. Frame: inertial.
    pub(super) rows: &'r Square<T>,
    /// Number of rows, and how many of them, the first ones, hold translations.
    pub(super) counts: [usize; 2],
    /// Whether its first three rows are the inertial axes.
    pub(super) holds_point: bool,
}

/// The motions that a support leaves a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Supported<T> {
    slot: usize,
    /// From the marker's place relative to the centre of mass to where rows act. Frame: inertial. Units: m.
    arm: Vector3<T>,
    sign: T,
    counts: [usize; 2],
    holds_point: bool,
    /// Duals of the rows: of translations, if they hold no point, and of rotations. Frame: inertial.
    duals: [[Vector3<T>; 3]; 2],
    /// s_k. Shape: 6 each.
    motions: [[T; 6]; MOST_LEFT],
    /// s_kᵀ M s_k; one where there is none.
    masses: [T; MOST_LEFT],
    /// How many motions there are.
    left: usize,
    /// a_0. Shape: 6.
    asked: [T; 6],
}

impl<T: RealField + Copy> Supported<T> {
    /// What `support` leaves a body with this frame; `at`: its marker (body frame). `None` where its rows are not independent.
    pub(super) fn new(frame: &RigidFrame<T>, at: &Vector3<T>, support: &Support<'_, T>) -> Option<Self> {
        let Support { slot, beyond, sign, rows, counts, holds_point, .. } = support;
        let none = [T::zero(); 6];
        let mut supported = Self {
            slot: *slot,
            arm: frame.arm(at) + beyond,
            sign: *sign,
            counts: *counts,
            holds_point: *holds_point,
            duals: [[Vector3::zeros(); 3]; 2],
            motions: [none; MOST_LEFT],
            masses: [T::one(); MOST_LEFT],
            left: 0,
            asked: none,
        };
        let [count, translations] = *counts;
        let three = |axes: [usize; 3], start: usize| {
            [start, start + 1, start + 2]
                .map(|row| Vector3::from(axes.map(|axis| rows[axis].get(row).copied().unwrap_or(T::zero()))))
        };
        let (arm, mut duals) = (supported.arm, supported.duals);
        let mut fits = true;
        if !*holds_point {
            fits &= hold(&three([0, 1, 2], 0), translations, &mut duals[0], |free| {
                supported.leave(frame, frame.components(free, &Vector3::zeros(), &arm));
            });
        }
        fits &= hold(
            &three([3, 4, 5], translations),
            count.saturating_sub(translations),
            &mut duals[1],
            |free| {
                supported.leave(frame, frame.components(&Vector3::zeros(), free, &arm));
            },
        );
        supported.duals = duals;
        let sound = supported.masses.iter().fold(T::zero(), |sum, mass| sum + T::one() / *mass);
        (fits && sound.is_finite()).then_some(supported)
    }

    /// Adds a motion, with those before it taken out.
    fn leave(&mut self, frame: &RigidFrame<T>, mut motion: [T; 6]) {
        let left = self.left;
        for (before, mass) in self.motions.iter().zip(&self.masses).take(left) {
            let share = dot(&products(frame.masses(), before), &motion) / *mass;
            subtract_scaled(&mut motion, share, before);
        }
        if let (Some(place), Some(mass)) = (self.motions.get_mut(left), self.masses.get_mut(left)) {
            *mass = dot(&products(frame.masses(), &motion), &motion);
            *place = motion;
            self.left += 1;
        }
    }

    /// Which of the ends of joints on the body its support is.
    pub(super) fn slot(&self) -> usize {
        self.slot
    }

    /// The diagonal of the mass matrix of the unknowns.
    pub(super) fn masses(&self) -> [T; 6] {
        let ([first, second, third], one) = (self.masses, T::one());
        [one, one, one, first, second, third]
    }

    /// Takes effects of rows on the six components to those on the unknowns. Shape: 6 x rows.
    pub(super) fn project(&self, effects: &mut Square<T>) {
        let all = *effects;
        *effects = zeros();
        for (place, motion) in effects.iter_mut().skip(MOST_LEFT).zip(&self.motions).take(self.left) {
            for (row, amount) in all.iter().zip(motion) {
                add_scaled(place, *amount, row);
            }
        }
    }

    /// Takes what the rows of the support are to do: its a_0.
    pub(super) fn ask(&mut self, frame: &RigidFrame<T>, wanted: &[T; 6]) {
        let [x, y, z, a, b, c] = *wanted;
        let [_, translations] = self.counts;
        let sum = |duals: &[Vector3<T>; 3], wanted: [T; 3]| {
            duals.iter().zip(wanted).fold(Vector3::zeros(), |sum, (dual, wanted)| sum + dual * wanted)
        };
        let of_rotations = match translations {
            0 => [x, y, z],
            1 => [y, z, a],
            2 => [z, a, b],
            _ => [a, b, c],
        };
        let linear = if self.holds_point { Vector3::new(x, y, z) } else { sum(&self.duals[0], [x, y, z]) };
        let angular = sum(&self.duals[1], of_rotations);
        self.asked = scaled(self.sign, &frame.components(&linear, &angular, &self.arm));
    }

    /// a_0.
    pub(super) fn asked(&self) -> &[T; 6] {
        &self.asked
    }

    /// The force on the unknowns, of one on the six components.
    pub(super) fn force(&self, frame: &RigidFrame<T>, mut force: [T; 6]) -> [T; 6] {
        let inertial = products(frame.masses(), &self.asked);
        subtract_scaled(&mut force, T::one(), &inertial);
        let none = T::zero();
        let [first, second, third] = self.motions.map(|motion| dot(&motion, &force));
        [none, none, none, first, second, third]
    }

    /// The six components of these unknowns.
    pub(super) fn motion(&self, [_, _, _, first, second, third]: &[T; 6]) -> [T; 6] {
        let mut motion = self.asked;
        for (amount, own) in [first, second, third].into_iter().zip(&self.motions) {
            add_scaled(&mut motion, *amount, own);
        }
        motion
    }
}
