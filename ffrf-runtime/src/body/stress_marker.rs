//! Stress markers: places of a flexible body where stress is observed.

use nalgebra::{RealField, SVector, Vector3, convert};

use super::ModalVector;

/// A place of a flexible body with the stress there per unit modal coordinate; `V` is the body's modal vector.
///
/// The stress is that of the modes: what the modes do not hold (contact, notches, the stress of a load where it acts) is not in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StressMarker<V, T = f64> {
    /// Reference position in the body frame. Shape: 3. Units: m.
    pub position: Vector3<T>,
    /// Stress xx, yy, zz, xy, xz, yz per unit modal coordinate. Shape: 6 x M. Units: N/m² for unit modes. Frame: body.
    pub stress: [V; 6],
}

impl<const M: usize> StressMarker<SVector<f64, M>, f64> {
    /// The marker in another number type: of a generic body, whose constants are f64.
    pub fn cast<T: RealField + Copy>(&self) -> StressMarker<SVector<T, M>, T> {
        StressMarker { position: self.position.map(convert), stress: self.stress.map(|row| row.map(convert)) }
    }
}

impl<V: ModalVector<T>, T: RealField + Copy> StressMarker<V, T> {
    /// Stress of a deformation: xx, yy, zz, xy, xz, yz. Units: N/m². Frame: body.
    #[inline]
    pub fn stress(&self, q: &V) -> [T; 6] {
        self.stress.each_ref().map(|row| row.dot(q))
    }

    /// Von Mises' equivalent stress of a deformation. Units: N/m².
    #[inline]
    pub fn von_mises(&self, q: &V) -> T {
        von_mises(&self.stress(q))
    }
}

/// Von Mises' equivalent of a stress xx, yy, zz, xy, xz, yz: √(½ Σ (σ_ii - σ_jj)² + 3 Σ σ_ij²).
///
/// Units: those of the stress. Source: R. von Mises, Nachr. Ges. Wiss. Göttingen (1913).
#[inline]
pub fn von_mises<T: RealField + Copy>(stress: &[T; 6]) -> T {
    let [xx, yy, zz, xy, xz, yz] = *stress;
    let (half, three): (T, T) = (convert(0.5), convert(3.0));
    let [a, b, c] = [xx - yy, yy - zz, zz - xx];
    let square = half * (a * a + b * b + c * c) + three * (xy * xy + xz * xz + yz * yz);
    // Where there is no stress the root has no derivative; numbers that carry one get zero.
    if square > T::zero() { square.sqrt() } else { T::zero() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    #[test]
    fn known_states_of_stress_have_their_equivalents() {
        // Pull, pressure from all sides, shear.
        assert_eq!(von_mises(&[3.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 3.0);
        assert_eq!(von_mises(&[-2.0, -2.0, -2.0, 0.0, 0.0, 0.0]), 0.0);
        assert_eq!(von_mises(&[0.0, 0.0, 0.0, 0.0, 2.0, 0.0]), 12.0_f64.sqrt());
    }

    #[test]
    fn the_stress_is_linear_in_the_modes() {
        let row = |a: f64, b: f64| Vector2::new(a, b);
        let marker = StressMarker {
            position: Vector3::zeros(),
            stress: [
                row(1.0, 0.0),
                row(0.0, 2.0),
                row(0.0, 0.0),
                row(3.0, -1.0),
                row(0.0, 0.0),
                row(0.5, 0.5),
            ],
        };
        assert_eq!(marker.stress(&Vector2::new(2.0, 1.0)), [2.0, 2.0, 0.0, 5.0, 0.0, 1.5]);
        let single = marker.cast::<f32>();
        assert_eq!(
            single.von_mises(&Vector2::new(2.0, 1.0)),
            marker.von_mises(&Vector2::new(2.0, 1.0)) as f32
        );
    }
}
