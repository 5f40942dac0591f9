//! A rigid body that stands on a support.

use nalgebra::{RealField, Vector3};

use super::support::Supported;
use super::{AttachedRows, BodyPort, Room, Support, SupportPort};
use crate::body::FlexibleBody;

impl<B, R, T, K> SupportPort<T> for BodyPort<'_, B, R, T, K>
where
    B: FlexibleBody<T>,
    R: AsRef<[Option<AttachedRows<B::Modal, T>>]> + AsMut<[Option<AttachedRows<B::Modal, T>>]>,
    T: RealField + Copy,
{
    fn stand_on(&mut self, support: &Support<'_, T>) -> bool {
        let Some(at) = self.markers.get(support.marker) else { return false };
        self.room.supported =
            self.room.frame.as_ref().and_then(|frame| Supported::new(frame, &at.position, support));
        self.room.supported.is_some()
    }

    fn support(&self) -> Option<usize> {
        self.room.supported.as_ref().map(Supported::slot)
    }

    fn ask_of_support(&mut self, wanted: &[T; 6]) {
        if let (Some(frame), Some(supported)) = (&self.room.frame, &mut self.room.supported) {
            supported.ask(frame, wanted);
        }
    }

    fn supported_twist(&self, marker: usize) -> Option<[Vector3<T>; 2]> {
        let Room { frame: Some(frame), supported: Some(supported), .. } = &*self.room else { return None };
        Some(frame.twist(supported.asked(), &self.markers.get(marker)?.position))
    }

    fn unforced(&self) -> [T; 6] {
        let zeros = [T::zero(); 6];
        match (&self.room.frame, &self.room.supported) {
            (Some(frame), Some(supported)) => supported.force(frame, zeros),
            _ => zeros,
        }
    }
}
