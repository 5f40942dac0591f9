//! Relative deviations, block by block, as the format of the reference cases asks for.

use ffrf::nalgebra::{Matrix3, Quaternion, SVector, UnitQuaternion, Vector3};
use serde_json::Value;

/// A block this much smaller than its scale is zero up to round-off; it is then compared against the scale itself.
const ZERO_BLOCK: f64 = 1e-9;

pub fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        number => vec![number.as_f64().expect("a number")],
    }
}

pub fn vector<const R: usize>(value: &Value) -> SVector<f64, R> {
    SVector::from_vec_storage_checked(numbers(value))
}

trait FromNumbers {
    fn from_vec_storage_checked(numbers: Vec<f64>) -> Self;
}

impl<const R: usize> FromNumbers for SVector<f64, R> {
    fn from_vec_storage_checked(numbers: Vec<f64>) -> Self {
        assert_eq!(numbers.len(), R);
        SVector::from_column_slice(&numbers)
    }
}

/// A(θ) for Euler parameters, scalar first; maps body to inertial components.
pub fn rotation(theta: &Value) -> Matrix3<f64> {
    let t = numbers(theta);
    *UnitQuaternion::from_quaternion(Quaternion::new(t[0], t[1], t[2], t[3])).to_rotation_matrix().matrix()
}

/// max |found - expected| over the block, relative to its largest entry, or to `scale` where the block is zero.
pub fn deviation(found: &[f64], expected: &[f64], scale: f64) -> f64 {
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let reference = if largest > ZERO_BLOCK * scale { largest } else { scale };
    let difference = found.iter().zip(expected).map(|(f, e)| (f - e).abs()).fold(0.0, |m: f64, x| if x > m || x.is_nan() { x } else { m });
    if difference == 0.0 { 0.0 } else { difference / reference }
}

/// Deviation of a vector of 6 + M numbers in its blocks: translation, rotation, modes.
pub fn vector_deviation(found: &[f64], expected: &[f64]) -> f64 {
    let scale = expected.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    [0..3, 3..6, 6..expected.len()]
        .into_iter()
        .map(|block| deviation(&found[block.clone()], &expected[block], scale))
        .fold(0.0, f64::max)
}

pub fn vector3(value: &Value) -> Vector3<f64> {
    vector::<3>(value)
}
