//! Motions of a body prescribed in time, with their exact derivatives by dual numbers.

use ffrf_runtime::nalgebra::{Quaternion, RealField, SVector, UnitQuaternion, Vector3, convert};
use ffrf_runtime::{Motion, State};
use num_dual::{Dual2, Dual2_64};

/// The three derivatives of a motion of a body, as the runtime writes them.
pub struct Prescribed<const M: usize> {
    /// Place and velocities.
    pub state: State<SVector<f64, M>>,
    /// Accelerations.
    pub acceleration: Motion<SVector<f64, M>>,
    /// The place as a function of time: value, rate and second derivative. Its velocities are zero.
    pub place: State<SVector<Dual2_64, M>, Dual2_64>,
}

/// A smooth function of time that differs for each `k`, of order one with its derivatives.
pub fn wave<T: RealField + Copy>(k: usize, time: T) -> T {
    let number = |x: f64| convert::<f64, T>(x);
    let phase = (k as f64 * 1.7 + 0.3).sin() * 3.0;
    let frequency = 0.6 + 0.9 * (k as f64 * 0.83).cos().abs();
    (time * number(frequency) + number(phase)).sin() + time * time * number(0.1 * phase)
}

impl<const M: usize> Prescribed<M> {
    /// The motion of this number at `time`.
    pub fn at(seed: usize, time: f64) -> Self {
        let time = Dual2::new(time, 1.0, 0.0);
        let wave = |k: usize| wave(k + 20 * seed, time);
        let position = Vector3::from_fn(|k, _| wave(k));
        // nowhere near zero: the first entry is above 2 at the times of the tests
        let quaternion = Quaternion::new(wave(3) + Dual2::new(3.0, 0.0, 0.0), wave(4), wave(5), wave(6));
        let orientation = UnitQuaternion::from_quaternion(quaternion);
        let q = SVector::<_, M>::from_fn(|k, _| wave(k + 7) * Dual2::new(0.3, 0.0, 0.0));
        let place = State {
            position,
            orientation,
            modal_coordinates: q,
            velocity: Vector3::zeros(),
            angular_velocity: Vector3::zeros(),
            modal_rates: SVector::zeros(),
        };
        let turned = UnitQuaternion::new_unchecked(parts(&orientation, |x| x.re));
        let [first, second] = [parts(&orientation, |x| x.v1), parts(&orientation, |x| x.v2)];
        let state = State {
            position: position.map(|x| x.re),
            orientation: turned,
            modal_coordinates: q.map(|x| x.re),
            velocity: position.map(|x| x.v1),
            // θ̇ = ½ θ ⊗ [0, ω], and once more: θ* ⊗ θ̈ has ½ ω̇ in its vector
            angular_velocity: (turned.quaternion().conjugate() * first).imag() * 2.0,
            modal_rates: q.map(|x| x.v1),
        };
        let acceleration = Motion {
            linear: turned.inverse_transform_vector(&position.map(|x| x.v2)),
            angular: (turned.quaternion().conjugate() * second).imag() * 2.0,
            modal: q.map(|x| x.v2),
        };
        Self { state, acceleration, place }
    }
}

/// A quaternion of one part of dual numbers.
pub fn parts<T: RealField + Copy>(
    orientation: &UnitQuaternion<T>,
    part: impl Fn(T) -> f64,
) -> Quaternion<f64> {
    Quaternion::new(part(orientation.w), part(orientation.i), part(orientation.j), part(orientation.k))
}
