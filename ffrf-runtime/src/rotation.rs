//! Rotations: the one convention of this project, and the way to and from Euler parameters.
//!
//! - The orientation is a unit quaternion θ, nalgebra's [`UnitQuaternion`]. Its rotation matrix A maps
//!   components in the body frame to components in the inertial frame: `inertial = orientation * body`.
//! - Euler parameters are written scalar first, [θ0, θ1, θ2, θ3], as in the paper. nalgebra *stores*
//!   quaternions scalar last, so never reinterpret its coordinates: use the two functions here.
//! - The angular velocity ω is resolved in the body frame; θ̇ = ½ θ ⊗ [0, ω], which is (212) read backwards:
//!   ω = Ḡ θ̇ with Ḡ = 2 [-θ⃗, θ0 I - θ⃗~].
//!
//! ```
//! use ffrf_runtime::nalgebra::Vector3;
//! use ffrf_runtime::rotation;
//!
//! // a quarter turn about z takes the body's x axis to the inertial y axis
//! let half = core::f64::consts::FRAC_1_SQRT_2;
//! let orientation = rotation::from_euler_parameters([half, 0.0, 0.0, half]).expect("not zero");
//! assert!((orientation * Vector3::x() - Vector3::y()).norm() < 1e-15);
//! assert_eq!(rotation::euler_parameters(&orientation)[0], half);
//! ```

use nalgebra::{Matrix3, Quaternion, RealField, UnitQuaternion, Vector3};

/// Euler parameters [θ0, θ1, θ2, θ3], scalar first. Shape: 4. Units: 1. Panics: never.
pub fn euler_parameters<T: RealField + Copy>(orientation: &UnitQuaternion<T>) -> [T; 4] {
    [orientation.w, orientation.i, orientation.j, orientation.k]
}

/// The orientation of Euler parameters [θ0, θ1, θ2, θ3], scalar first, scaled to unit norm.
///
/// Parameters of any size have a direction, as long as they are finite and not all zero: else `None`. Panics: never.
pub fn from_euler_parameters<T: RealField + Copy>(parameters: [T; 4]) -> Option<UnitQuaternion<T>> {
    let [scalar, i, j, k] = parameters;
    let quaternion = Quaternion::new(scalar, i, j, k);
    let small = T::default_epsilon();
    let norm = quaternion.norm_squared();
    if norm > small * small && norm * small * small < T::one() {
        return normalised(quaternion);
    }
    // squares of these would lose digits, or leave the number type
    let size = quaternion.coords.amax();
    if size > T::zero() && parameters.iter().all(|parameter| parameter.is_finite()) {
        normalised(quaternion / size)
    } else {
        None
    }
}

/// Rate of the quaternion, θ̇ = ½ θ ⊗ [0, ω], with ω in the body frame. Shape: 4. Units: 1/s. Panics: never.
pub fn quaternion_rate<T: RealField + Copy>(
    orientation: &Quaternion<T>,
    omega: &Vector3<T>,
) -> Quaternion<T> {
    let half: T = nalgebra::convert(0.5);
    orientation * Quaternion::from_imag(omega * half)
}

/// Angular velocity ω = 2 θ* ⊗ θ̇ of a unit quaternion and its rate. Shape: 3. Units: rad/s. Frame: body.
///
/// Source: (212), ω = Ḡ θ̇. Panics: never.
pub fn angular_velocity<T: RealField + Copy>(
    orientation: &UnitQuaternion<T>,
    rate: &Quaternion<T>,
) -> Vector3<T> {
    let two: T = nalgebra::convert(2.0);
    (orientation.quaternion().conjugate() * rate).imag() * two
}

/// The rotation of a small rotation vector by the Cayley map: quaternion (1, ϑ/2), normalised.
///
/// Rational but for the norm, the same bits on every target, and its angular velocity is rational in ϑ̇; it turns by
/// 2 atan(|ϑ|/2), which is |ϑ| to third order. Shape: 3. Units: rad.
pub fn cayley<T: RealField + Copy>(rotation: &Vector3<T>) -> UnitQuaternion<T> {
    let half = rotation * nalgebra::convert::<f64, T>(0.5);
    let quaternion = Quaternion::from_parts(T::one(), half);
    UnitQuaternion::new_unchecked(quaternion / quaternion.norm())
}

/// `orientation` followed by the [`cayley`] map of `rotation`, in the components of the frame that it turns.
///
/// The norm is taken of the product: a long row of turns stays a unit quaternion to the last digit, where a row of
/// unit quaternions would lose a tenth of a unit in the last place with each. Shape: 3. Units: rad.
pub fn turned<T: RealField + Copy>(
    orientation: &UnitQuaternion<T>,
    rotation: &Vector3<T>,
) -> UnitQuaternion<T> {
    let half = rotation * nalgebra::convert::<f64, T>(0.5);
    let product = orientation.quaternion() * Quaternion::from_parts(T::one(), half);
    UnitQuaternion::new_unchecked(product / product.norm())
}

/// The matrix of a rotation; an axis that it leaves where it is stays there to the last bit. Shape: 3 x 3. Panics: never.
///
/// I + 2 (w v~ + v~ v~) of the quaternion (w, v).
pub fn matrix<T: RealField + Copy>(orientation: &UnitQuaternion<T>) -> Matrix3<T> {
    let [i, j, k, w]: [T; 4] = orientation.coords.into();
    let [i2, j2, k2] = [i + i, j + j, k + k];
    let (one, [wi, wj, wk], [ii, ij, ik], [jj, jk, kk]) =
        (T::one(), [w * i2, w * j2, w * k2], [i * i2, i * j2, i * k2], [j * j2, j * k2, k * k2]);
    Matrix3::new(
        one - (jj + kk),
        ij - wk,
        ik + wj,
        ij + wk,
        one - (ii + kk),
        jk - wi,
        ik - wj,
        jk + wi,
        one - (ii + jj),
    )
}

/// The rate of the rotation vector c whose [`cayley`] map turns a frame, when it turns with ω in its own components.
///
/// ċ = ω + ½ c × ω + ¼ c (c · ω). Shape: 3. Units: rad/s. Frame: the turned one. Source: θ̇ = ½ θ ⊗ [0, ω] with
/// θ proportional to (1, c/2).
pub fn cayley_rate<T: RealField + Copy>(rotation: &Vector3<T>, omega: &Vector3<T>) -> Vector3<T> {
    let half = rotation * nalgebra::convert::<f64, T>(0.5);
    omega + half.cross(omega) + half * half.dot(omega)
}

/// The inverse of [`cayley_rate`]: the ω with which the rotation vector c changes at `rate`.
///
/// ω = (ċ - ½ c × ċ) / (1 + ¼ c · c). Shape: 3. Units: rad/s. Frame: the turned one.
pub fn cayley_omega<T: RealField + Copy>(rotation: &Vector3<T>, rate: &Vector3<T>) -> Vector3<T> {
    let half = rotation * nalgebra::convert::<f64, T>(0.5);
    (rate - half.cross(rate)) / (T::one() + half.norm_squared())
}

/// The unit quaternion in the direction of `quaternion`; `None` without a direction.
fn normalised<T: RealField + Copy>(quaternion: Quaternion<T>) -> Option<UnitQuaternion<T>> {
    let norm = quaternion.norm();
    // a NaN fails this comparison as well
    (norm > T::zero() && norm.is_finite()).then(|| UnitQuaternion::new_unchecked(quaternion / norm))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn euler_parameters_survive_the_way_there_and_back() {
        let parameters = [0.5, -0.5, 0.5, 0.5];
        let orientation = from_euler_parameters(parameters).unwrap();
        assert_eq!(euler_parameters(&orientation), parameters);
        // A of (213), first column: [θ0² + θ1² - θ2² - θ3², 2(θ1 θ2 + θ0 θ3), 2(θ1 θ3 - θ0 θ2)]
        let column = orientation * Vector3::x();
        assert!((column - Vector3::new(0.0, 0.0, -1.0)).norm() < 1e-15, "{column}");
    }

    #[test]
    fn angular_velocity_and_quaternion_rate_are_inverse() {
        let orientation = from_euler_parameters([0.3, -0.5, 0.7, 0.1]).unwrap();
        let omega = Vector3::<f64>::new(1.0, -2.0, 0.5);
        let rate = quaternion_rate(&orientation, &omega);
        assert!((angular_velocity(&orientation, &rate) - omega).norm() < 1e-14);
        // the rate is tangent to the unit sphere
        let radial: f64 = rate.coords.dot(&orientation.coords);
        assert!(radial.abs() < 1e-15);
        // Ȧ = A ω~ by a difference of second order
        let step = 1e-5;
        let ahead = from_euler_parameters(array(orientation.quaternion() + rate * step)).unwrap();
        let behind = from_euler_parameters(array(orientation.quaternion() - rate * step)).unwrap();
        let arm = Vector3::new(0.2, 0.4, -0.9);
        let difference = (ahead * arm - behind * arm) / (2.0 * step);
        assert!((difference - orientation * omega.cross(&arm)).norm() < 1e-9);
    }

    #[test]
    fn nothing_and_not_a_number_have_no_orientation() {
        assert_eq!(from_euler_parameters([0.0; 4]), None);
        assert_eq!(from_euler_parameters([1.0, f64::NAN, 0.0, 0.0]), None);
        assert_eq!(from_euler_parameters([f64::INFINITY, 0.0, 0.0, 0.0]), None);
        assert_eq!(from_euler_parameters([f64::MAX, f64::NAN, 0.0, 0.0]), None);
    }

    #[test]
    fn parameters_of_any_size_have_a_direction() {
        let unit = from_euler_parameters([0.5, -0.5, 0.5, 0.5]);
        for size in [f64::MAX, 1e200, 1e-17, 1e-200, f64::MIN_POSITIVE] {
            assert_eq!(from_euler_parameters([size, -size, size, size]), unit, "{size:e}");
        }
    }

    fn array(quaternion: Quaternion<f64>) -> [f64; 4] {
        [quaternion.w, quaternion.i, quaternion.j, quaternion.k]
    }
}
