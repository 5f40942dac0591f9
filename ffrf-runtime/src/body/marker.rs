//! Markers: points of a flexible body where forces act, joints hold and motion is observed.

use nalgebra::{RealField, SVector, Vector3};

use super::{GeneralisedForce, ModalVector};
use crate::six::{add_scaled, scaled, subtract_scaled};

/// A point of a flexible body, with the rows of the mode shapes there; `V` is the body's modal vector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Marker<V, T = f64> {
    /// Reference position in the body frame. Shape: 3. Units: m.
    pub position: Vector3<T>,
    /// Displacement along x, y and z per unit modal coordinate. Shape: 3 x M.
    pub translation: [V; 3],
    /// Small rotation about x, y and z per unit modal coordinate. Shape: 3 x M. Units: rad.
    pub rotation: [V; 3],
    /// Number of the marker among those of its body if loads there stress the body, so that its rows follow the deformation: see
    /// [`bent_marker`](super::FlexibleBody::bent_marker).
    pub stressing: Option<u16>,
}

impl<const M: usize> Marker<SVector<f64, M>, f64> {
    /// The marker in another number type: of a generic body, whose constants are f64, for dual numbers, say.
    pub fn cast<T: RealField + Copy>(&self) -> Marker<SVector<T, M>, T> {
        let rows = |rows: &[SVector<f64, M>; 3]| rows.map(|row| row.map(nalgebra::convert));
        Marker {
            position: self.position.map(nalgebra::convert),
            translation: rows(&self.translation),
            rotation: rows(&self.rotation),
            stressing: self.stressing,
        }
    }
}

impl<V: ModalVector<T>, T: RealField + Copy> Marker<V, T> {
    /// A marker on the rigid part of a body: the modes, as many as in `alike`, do not move it.
    pub fn rigid(position: Vector3<T>, alike: &V) -> Self {
        let still = || core::array::from_fn(|_| alike.zeros_alike());
        Self { position, translation: still(), rotation: still(), stressing: None }
    }

    /// Position from the frame origin in the deformed state, x + Ψ q. Shape: 3. Units: m. Frame: body.
    #[inline]
    pub fn position(&self, q: &V) -> Vector3<T> {
        self.position + combine(&self.translation, q)
    }

    /// Velocity of the marker, v + ω × (x + Ψ q) + Ψ q̇, where v is that of the frame origin.
    ///
    /// Shape: 3. Units: m/s. Frame: inertial velocity resolved in the body frame.
    pub fn velocity(&self, q: &V, velocity: &Vector3<T>, omega: &Vector3<T>, q_dot: &V) -> Vector3<T> {
        velocity + omega.cross(&self.position(q)) + combine(&self.translation, q_dot)
    }

    /// Small rotation ϑ of the material at the marker relative to the body frame. Shape: 3. Units: rad. Frame: body.
    ///
    /// Its finite rotation is [`cayley`](crate::rotation::cayley) of it: quaternion (1, ϑ/2), normalised.
    #[inline]
    pub fn small_rotation(&self, q: &V) -> Vector3<T> {
        combine(&self.rotation, q)
    }

    /// Angular velocity of the material at the marker: ω and the exact rate of the finite rotation.
    ///
    /// ω + (ϑ̇ + ½ ϑ × ϑ̇) / (1 + |ϑ|²/4). Shape: 3. Units: rad/s. Frame: body.
    pub fn angular_velocity(&self, q: &V, omega: &Vector3<T>, q_dot: &V) -> Vector3<T> {
        let rotation = SmallRotation::new(self.small_rotation(q));
        omega + rotation.times(&combine(&self.rotation, q_dot))
    }

    /// Generalised force of a force f̄ at the marker: [f̄; (x + Ψ q) × f̄; φ_μ · f̄].
    ///
    /// Dual to [`velocity`](Self::velocity): its power is f̄ times the marker's velocity. Frame: body.
    /// Source: (199)-(201) with the deformed lever arm.
    pub fn force(&self, q: &V, force: &Vector3<T>) -> GeneralisedForce<V, T> {
        let moment = self.position(q).cross(force);
        GeneralisedForce { force: *force, moment, modal: transposed(&self.translation, force) }
    }

    /// Generalised force of a moment τ at the marker, dual to [`angular_velocity`](Self::angular_velocity).
    ///
    /// [0; τ; rotation_μ · Wᵀτ] with the W of that function. Frame: body.
    pub fn moment(&self, q: &V, moment: &Vector3<T>) -> GeneralisedForce<V, T> {
        let turned = SmallRotation::new(self.small_rotation(q)).transposed_times(moment);
        GeneralisedForce {
            force: Vector3::zeros(),
            moment: *moment,
            modal: transposed(&self.rotation, &turned),
        }
    }
}

/// The finite rotation of a small one by the Cayley map, and how its rate follows.
///
/// ω_rel = W ϑ̇ with W = (I + ½ ϑ~) / (1 + |ϑ|²/4), resolved in the frame before the rotation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SmallRotation<T> {
    pub(crate) half: Vector3<T>,
    /// 1 / (1 + |ϑ|²/4)
    pub(crate) share: T,
}

impl<T: RealField + Copy> SmallRotation<T> {
    #[inline]
    pub(crate) fn new(rotation: Vector3<T>) -> Self {
        let half = rotation * nalgebra::convert::<f64, T>(0.5);
        Self { half, share: T::one() / (T::one() + half.norm_squared()) }
    }

    /// W u
    #[inline]
    pub(crate) fn times(&self, vector: &Vector3<T>) -> Vector3<T> {
        (vector + self.half.cross(vector)) * self.share
    }

    /// Wᵀ of six vectors, component by component.
    #[inline]
    pub(crate) fn transposed_times_rows(&self, [x, y, z]: &[[T; 6]; 3]) -> [[T; 6]; 3] {
        let (half, share) = (&self.half, self.share);
        let turned = |own: &[T; 6], next: (T, &[T; 6]), last: (T, &[T; 6])| {
            let mut sum = *own;
            add_scaled(&mut sum, next.0, next.1);
            subtract_scaled(&mut sum, last.0, last.1);
            scaled(share, &sum)
        };
        [
            turned(x, (half.z, y), (half.y, z)),
            turned(y, (half.x, z), (half.z, x)),
            turned(z, (half.y, x), (half.x, y)),
        ]
    }

    /// Wᵀ u
    #[inline]
    pub(crate) fn transposed_times(&self, vector: &Vector3<T>) -> Vector3<T> {
        (vector - self.half.cross(vector)) * self.share
    }
}

/// Σ_μ c_μ times the displacements of mode μ.
#[inline]
pub(crate) fn combine<V: ModalVector<T>, T: RealField + Copy>(rows: &[V; 3], coefficients: &V) -> Vector3<T> {
    let [x, y, z] = rows;
    Vector3::new(x.dot(coefficients), y.dot(coefficients), z.dot(coefficients))
}

/// The displacements of each mode along `vector`.
#[inline]
pub(crate) fn transposed<V: ModalVector<T>, T: RealField + Copy>(rows: &[V; 3], vector: &Vector3<T>) -> V {
    let [x, y, z] = rows;
    let mut sum = x.clone();
    sum.scale(vector.x);
    sum.add_scaled(vector.y, y);
    sum.add_scaled(vector.z, z);
    sum
}
