//! What the code of `mechanism!` calls: numbers, triads and rows of the right size.

use nalgebra::{Matrix3, Quaternion, RealField, UnitQuaternion, Vector3};

use super::constraints::is_worse;
use super::{Attachment, Connection, KeptModes, along_axis};
use crate::body::{FlexibleBody, Increment, ModalVector, State};
use crate::joints::{Fixed, JointKind};
use crate::rotation::cayley_omega;

/// Three numbers as a vector.
pub fn vector3<T: RealField + Copy>(components: [f64; 3]) -> Vector3<T> {
    components.map(nalgebra::convert).into()
}

/// Numbers in the scalar type.
pub fn numbers<const N: usize, T: RealField + Copy>(numbers: [f64; N]) -> [T; N] {
    numbers.map(nalgebra::convert)
}

/// An inertia tensor as users write it: three principal moments, or three rows.
pub trait WrittenInertia {
    /// The tensor. Shape: 3 x 3.
    fn tensor<T: RealField + Copy>(self) -> Matrix3<T>;
}

impl WrittenInertia for [f64; 3] {
    fn tensor<T: RealField + Copy>(self) -> Matrix3<T> {
        Matrix3::from_diagonal(&vector3(self))
    }
}

impl WrittenInertia for [[f64; 3]; 3] {
    fn tensor<T: RealField + Copy>(self) -> Matrix3<T> {
        Matrix3::from_columns(&self.map(vector3)).transpose()
    }
}

/// The second triad of a universal joint: z along what is x of the first.
pub fn crossed<T: RealField + Copy>(first: &UnitQuaternion<T>) -> UnitQuaternion<T> {
    along_axis(&first.transform_vector(&Vector3::x()))
}

/// A place for a connection: what it holds is replaced.
pub fn unconnected<T: RealField + Copy>() -> Connection<T> {
    let nowhere = Attachment::on_ground(Vector3::zeros(), UnitQuaternion::identity());
    Connection { kind: JointKind::Fixed(Fixed), first: nowhere, second: nowhere }
}

/// Puts `count` connections from `start` on.
pub fn connect<T: RealField + Copy>(
    connections: &mut [Connection<T>],
    start: usize,
    count: usize,
    make: impl Fn(usize) -> Connection<T>,
) {
    for (index, place) in connections.iter_mut().skip(start).take(count).enumerate() {
        *place = make(index);
    }
}

/// Room for the modes of a body, if it keeps them as unknowns.
pub fn kept<B: FlexibleBody<T>, T: RealField + Copy>(
    body: &B,
    keeps: bool,
) -> Option<KeptModes<B::Modal, T>> {
    keeps.then(|| KeptModes::empty(&body.undeformed()))
}

/// Places that nothing was written to: nothing but their absence is stored.
#[inline(always)]
pub fn absent<P: Copy, const N: usize>() -> [Option<P>; N] {
    // not `from_fn`, which copies long arrays
    [None; N]
}

/// The first of several equal bodies.
pub fn first<const N: usize, B>(bodies: &[B; N]) -> &B {
    const { assert!(N > 0) };
    &bodies[0]
}

/// Puts the numbers of a state into the next places, those of the orientation as they are stored: i, j, k, w.
/// Shape: 13 + 2 M.
#[inline]
pub fn put_state<'a, V: ModalVector<T>, T: RealField + Copy>(
    state: &State<V, T>,
    places: &mut impl Iterator<Item = &'a mut T>,
) {
    put(state.position.as_slice(), places);
    put(state.orientation.coords.as_slice(), places);
    put(state.modal_coordinates.as_slice(), places);
    put(state.velocity.as_slice(), places);
    put(state.angular_velocity.as_slice(), places);
    put(state.modal_rates.as_slice(), places);
}

/// Puts numbers into the next places.
#[inline]
fn put<'a, T: Copy + 'a>(numbers: &[T], places: &mut impl Iterator<Item = &'a mut T>) {
    for (number, place) in numbers.iter().zip(places) {
        *place = *number;
    }
}

/// Takes numbers from the next places.
#[inline]
fn take<T>(numbers: &mut [T], places: &mut impl Iterator<Item = T>) {
    for (number, place) in numbers.iter_mut().zip(places) {
        *number = place;
    }
}

/// Takes the numbers of a state from the next places; see [`put_state`].
#[inline]
pub fn take_state<V: ModalVector<T>, T: RealField + Copy>(
    state: &mut State<V, T>,
    places: &mut impl Iterator<Item = T>,
) {
    let mut orientation = state.orientation.coords;
    take(state.position.as_mut_slice(), places);
    take(orientation.as_mut_slice(), places);
    take(state.modal_coordinates.as_mut_slice(), places);
    take(state.velocity.as_mut_slice(), places);
    take(state.angular_velocity.as_mut_slice(), places);
    take(state.modal_rates.as_mut_slice(), places);
    // of length one: it was divided by its length
    state.orientation = UnitQuaternion::new_unchecked(Quaternion::from(orientation));
}

/// Raises the largest place and the largest velocity to those of a body. Units: m; m/s or rad/s.
#[inline]
pub fn measure<V: ModalVector<T>, T: RealField + Copy>(state: &State<V, T>, largest: &mut [T; 2]) {
    let places = state.position.iter();
    let velocities = state.velocity.iter().chain(&state.angular_velocity);
    largest[0] = places.fold(largest[0], |largest, entry| largest.max(entry.abs()));
    largest[1] = velocities.fold(largest[1], |largest, entry| largest.max(entry.abs()));
}

/// The largest residuals of places and velocities before a projection, and after it. `residuals`: those of all rows, before of
/// places, then of velocities, then both after it.
#[inline]
pub fn largest_residuals<T: RealField + Copy>(residuals: &[T]) -> [[T; 2]; 2] {
    let mut largest = [[T::zero(); 2]; 2];
    let mut rows = residuals.chunks_exact((residuals.len() / 4).max(1));
    for (place, rows) in largest.as_flattened_mut().iter_mut().zip(&mut rows) {
        for residual in rows {
            if is_worse(residual.abs(), *place) {
                *place = residual.abs();
            }
        }
    }
    largest
}

/// The rate of an increment that has led to `state`, which has the next of these accelerations: of the frame origin
/// (inertial), angular (body), modal. Shape: 6 + M.
#[inline]
pub fn rate_with<V: ModalVector<T>, T: RealField + Copy>(
    increment: &Increment<V, T>,
    state: &State<V, T>,
    accelerations: &mut impl Iterator<Item = T>,
) -> Increment<V, T> {
    let mut rate = increment.place_rate(state);
    take(rate.velocity.as_mut_slice(), accelerations);
    take(rate.angular_velocity.as_mut_slice(), accelerations);
    take(rate.modal_rates.as_mut_slice(), accelerations);
    rate
}

/// Puts what a linearly implicit stage subtracts from the rates of a body into the next places: of the position (inertial), as
/// angular velocity (body), of the modal coordinates, of the velocity (inertial), of the angular velocity (body), of the modal
/// rates. `increment`: what has led to the state of the stage, in whose chart rotations are subtracted. Shape: 12 + 2 M.
#[inline]
pub fn put_subtracted<'a, V: ModalVector<T>, T: RealField + Copy>(
    subtracted: &Increment<V, T>,
    increment: &Increment<V, T>,
    places: &mut impl Iterator<Item = &'a mut T>,
) {
    let turned = cayley_omega(&increment.rotation, &subtracted.rotation);
    put(subtracted.position.as_slice(), places);
    put(turned.as_slice(), places);
    put(subtracted.modal_coordinates.as_slice(), places);
    put(subtracted.velocity.as_slice(), places);
    put(subtracted.angular_velocity.as_slice(), places);
    put(subtracted.modal_rates.as_slice(), places);
}

/// [`rate_with`] of a linearly implicit stage. `frames_follow`: whether the rates of frames' places see the end of the stage as
/// those of modes do, as with soft rows.
#[inline]
pub fn implicit_rate_with<V: ModalVector<T>, T: RealField + Copy>(
    increment: &Increment<V, T>,
    state: &State<V, T>,
    accelerations: &mut impl Iterator<Item = T>,
    gamma_h: T,
    subtracted: Option<&Increment<V, T>>,
    frames_follow: bool,
) -> Increment<V, T> {
    let mut rate = rate_with(increment, state, accelerations);
    rate.look_ahead(gamma_h, subtracted);
    if frames_follow {
        increment.follow_end(&mut rate, gamma_h);
    }
    rate
}
