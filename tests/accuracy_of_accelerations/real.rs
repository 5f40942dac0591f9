//! The two precisions.

use ffrf::generated_support::lanes;
use ffrf::nalgebra::RealField;
use ffrf_codegen::{ScalarType, expression};

/// A scalar of the interpreter, of the loops and of the factorisation alike.
pub trait Real: lanes::Scalar<Constant = Self> + expression::Scalar + RealField + Copy {
    const SCALAR: ScalarType;
    /// The spacing of numbers at 1.
    const EPSILON: f64;
    /// The nearest number.
    fn nearest(number: f64) -> Self;
    /// The same number.
    fn double(self) -> f64;
}

impl Real for f64 {
    const SCALAR: ScalarType = ScalarType::F64;
    const EPSILON: f64 = Self::EPSILON;
    fn nearest(number: f64) -> Self {
        number
    }
    fn double(self) -> f64 {
        self
    }
}

impl Real for f32 {
    const SCALAR: ScalarType = ScalarType::F32;
    const EPSILON: f64 = Self::EPSILON as f64;
    fn nearest(number: f64) -> Self {
        number as Self
    }
    fn double(self) -> f64 {
        f64::from(self)
    }
}
