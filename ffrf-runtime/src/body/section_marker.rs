//! Section markers: cuts through a flexible body where the transmitted force is observed.

use nalgebra::{RealField, SVector, Vector3, convert};

use super::ModalVector;
use super::marker::combine;

/// A cut through a flexible body, with the force and moment that go through it per unit modal coordinate; `V` is the body's modal
/// vector.
///
/// They are those of the modes, which the part on the side of the normal exerts on the rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionMarker<V, T = f64> {
    /// The point that moments are about, in the reference configuration. Shape: 3. Units: m. Frame: body.
    pub position: Vector3<T>,
    /// Force along x, y and z per unit modal coordinate. Shape: 3 x M. Units: N for unit modes. Frame: body.
    pub force: [V; 3],
    /// Moment about x, y and z per unit modal coordinate. Shape: 3 x M. Units: N m for unit modes. Frame: body.
    pub moment: [V; 3],
}

impl<const M: usize> SectionMarker<SVector<f64, M>, f64> {
    /// The marker in another number type: of a generic body, whose constants are f64.
    pub fn cast<T: RealField + Copy>(&self) -> SectionMarker<SVector<T, M>, T> {
        let rows = |rows: &[SVector<f64, M>; 3]| rows.map(|row| row.map(convert));
        SectionMarker {
            position: self.position.map(convert),
            force: rows(&self.force),
            moment: rows(&self.moment),
        }
    }
}

impl<V: ModalVector<T>, T: RealField + Copy> SectionMarker<V, T> {
    /// Force through the cut in a deformation. Shape: 3. Units: N. Frame: body.
    #[inline]
    pub fn force(&self, q: &V) -> Vector3<T> {
        combine(&self.force, q)
    }

    /// Moment through the cut, about its point. Shape: 3. Units: N m. Frame: body.
    #[inline]
    pub fn moment(&self, q: &V) -> Vector3<T> {
        combine(&self.moment, q)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    #[test]
    fn force_and_moment_are_linear_in_the_modes() {
        let row = |a: f64, b: f64| Vector2::new(a, b);
        let marker = SectionMarker {
            position: Vector3::zeros(),
            force: [row(1.0, 0.0), row(0.0, 2.0), row(3.0, -1.0)],
            moment: [row(0.5, 0.5), row(0.0, 0.0), row(0.0, -4.0)],
        };
        let q = Vector2::new(2.0, 1.0);
        assert_eq!(marker.force(&q), Vector3::new(2.0, 2.0, 5.0));
        assert_eq!(marker.moment(&q), Vector3::new(1.5, 0.0, -4.0));
        assert_eq!(marker.cast::<f32>().moment(&Vector2::new(2.0, 1.0)), Vector3::new(1.5, 0.0, -4.0));
    }
}
