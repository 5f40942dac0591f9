//! Rational numbers without rounding, as scalars of the interpreter.

use std::ops::{Add, Div, Mul, Neg, Sub};

use ffrf_codegen::expression::Scalar;
use num_rational::BigRational;

/// A rational number of any size.
#[derive(Debug, Clone, PartialEq)]
pub struct Exact(pub BigRational);

impl Scalar for Exact {
    fn from_constant(value: f64) -> Self {
        Self(BigRational::from_float(value).unwrap())
    }
    /// Exact for squares of rational numbers; any other argument is a mistake of the test.
    fn square_root(self) -> Self {
        let root = BigRational::new(self.0.numer().sqrt(), self.0.denom().sqrt());
        assert_eq!(&root * &root, self.0, "not a square");
        Self(root)
    }
}

impl Add for Exact {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Exact {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Exact {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for Exact {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl Neg for Exact {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}
