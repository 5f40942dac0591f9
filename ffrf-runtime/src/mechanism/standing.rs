//! Whether the body of a joint with the ground stands on it.

use nalgebra::RealField;

use super::{JointPlace, Ports};

/// The end of a joint with the ground on its body, and whether it is the second one.
pub(super) fn end_on_body(place: &JointPlace) -> Option<(usize, usize, bool)> {
    match place.ends {
        [Some(end), None] => Some((end.body, end.slot, false)),
        [None, Some(end)] => Some((end.body, end.slot, true)),
        _ => None,
    }
}

/// Whether the body of this joint stands on it.
pub(super) fn stands<T: RealField + Copy>(ports: &dyn Ports<T>, place: &JointPlace) -> bool {
    let Some((body, slot, _)) = end_on_body(place) else { return false };
    ports.port(body).is_some_and(|port| port.support() == Some(slot))
}
