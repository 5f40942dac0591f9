//! Markers whose rows follow the deformation, because loads there stress the body.

use nalgebra::{Matrix3, RealField, SVector, Vector3};

use super::marker::{SmallRotation, combine};
use super::{FlexibleBody, Marker, MarkerMotion, ModalVector, PlacedMarker, State};

/// The rows φ_μ - Γ_μν q_ν of a marker. `stiffness`: Γ of unit forces and moments there, which is symmetric. Shape: 6 x M x M.
/// `number`: from its number type to that of the marker.
#[inline]
pub fn bent<S, T, const M: usize>(
    marker: &Marker<SVector<T, M>, T>,
    stiffness: &[[[S; M]; M]; 6],
    q: &SVector<T, M>,
    number: impl Fn(S) -> T,
) -> Marker<SVector<T, M>, T>
where
    S: Copy,
    T: RealField + Copy,
{
    let mut bent = *marker;
    for (row, stiffness) in bent.translation.iter_mut().chain(&mut bent.rotation).zip(stiffness) {
        for (entry, along) in row.iter_mut().zip(stiffness) {
            let terms = along.iter().zip(q.iter());
            *entry -= terms.fold(T::zero(), |sum, (stiffness, q)| sum + number(*stiffness) * *q);
        }
    }
    bent
}

/// Place from the frame origin and small rotation of a marker whose rows follow the deformation: `bent` are those in this state,
/// `straight` those of the undeformed body. Both are integrals of the rows along q, which are linear in it: means of both.
fn integrated<V: ModalVector<T>, T: RealField + Copy>(
    bent: &Marker<V, T>,
    straight: &Marker<V, T>,
    q: &V,
) -> [Vector3<T>; 2] {
    let half: T = nalgebra::convert(0.5);
    [
        (bent.position(q) + straight.position(q)) * half,
        (bent.small_rotation(q) + straight.small_rotation(q)) * half,
    ]
}

/// Place from the frame origin and small rotation of a marker of a body.
pub(crate) fn place<B: FlexibleBody<T>, T: RealField + Copy>(
    body: &B,
    marker: &Marker<B::Modal, T>,
    q: &B::Modal,
) -> [Vector3<T>; 2] {
    match body.bent_marker(marker, q) {
        Some(bent) => integrated(&bent, marker, q),
        None => [marker.position(q), marker.small_rotation(q)],
    }
}

/// A marker of a body in a state, handed to what needs it.
#[inline]
pub(crate) fn with_placed<B: FlexibleBody<T>, T: RealField + Copy, U>(
    body: &B,
    marker: &Marker<B::Modal, T>,
    state: &State<B::Modal, T>,
    axes: &Matrix3<T>,
    take: impl FnOnce(PlacedMarker<'_, B::Modal, T>) -> U,
) -> U {
    match body.bent_marker(marker, &state.modal_coordinates) {
        Some(bent) => take(PlacedMarker::bent(&bent, marker, state, axes)),
        None => take(PlacedMarker::with_axes(marker, state, axes)),
    }
}

/// Place and motion of a marker of a body.
#[inline]
pub(crate) fn marker_motion<B: FlexibleBody<T>, T: RealField + Copy>(
    body: &B,
    marker: &Marker<B::Modal, T>,
    state: &State<B::Modal, T>,
    axes: &Matrix3<T>,
) -> MarkerMotion<T> {
    let rows = |along: &B::Modal| body.bent_marker(marker, along);
    match (rows(&state.modal_coordinates), rows(&state.modal_rates)) {
        (Some(bent), Some(rates)) => {
            PlacedMarker::bent(&bent, marker, state, axes).bent_motion(state, marker, &rates)
        }
        _ => PlacedMarker::with_axes(marker, state, axes).motion(state),
    }
}

impl<'a, V: ModalVector<T>, T: RealField + Copy> PlacedMarker<'a, V, T> {
    /// A marker whose rows follow the deformation: `bent` are those in this state, `straight` those of the undeformed body.
    #[inline]
    fn bent(bent: &'a Marker<V, T>, straight: &Marker<V, T>, state: &State<V, T>, axes: &Matrix3<T>) -> Self {
        let [arm, rotation] = integrated(bent, straight, &state.modal_coordinates);
        Self {
            marker: bent,
            orientation: state.orientation,
            axes: *axes,
            arm,
            rotation: SmallRotation::new(rotation),
        }
    }

    /// [`motion`](Self::motion) of a marker whose rows follow the deformation: `rates` are the rows for the rates in the place of the
    /// coordinates, and what they add to those of `straight` is the change of the rows with time.
    fn bent_motion(
        &self,
        state: &State<V, T>,
        straight: &Marker<V, T>,
        rates: &Marker<V, T>,
    ) -> MarkerMotion<T> {
        let mut motion = self.motion(state);
        let q_dot = &state.modal_rates;
        let change = |rows: &[V; 3], straight: &[V; 3]| combine(rows, q_dot) - combine(straight, q_dot);
        let turning = change(&rates.rotation, &straight.rotation);
        motion.acceleration_bias += self.axes * change(&rates.translation, &straight.translation);
        motion.angular_acceleration_bias += self.axes * self.rotation.times(&turning);
        motion
    }
}
