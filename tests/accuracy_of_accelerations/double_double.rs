//! Numbers of 106 bits, each the sum of two f64: what the errors of f64 are measured against.
//!
//! Source: T. J. Dekker, Numer. Math. 18 (1971); each operation is good to a few units of 2⁻¹⁰⁴.

use std::ops::{Add, Div, Mul, Neg, Sub};

use ffrf_codegen::expression::Scalar;

/// high + low, |low| at most half a unit in the last place of high.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// The nearest f64.
    pub fn value(self) -> f64 {
        self.high
    }
}

impl From<f64> for DoubleDouble {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

/// a + b without rounding.
fn sum(a: f64, b: f64) -> DoubleDouble {
    let high = a + b;
    let part = high - a;
    DoubleDouble { high, low: (a - (high - part)) + (b - part) }
}

/// a b without rounding.
fn product(a: f64, b: f64) -> DoubleDouble {
    let high = a * b;
    DoubleDouble { high, low: a.mul_add(b, -high) }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (sum(self.high, other.high), sum(self.low, other.low));
        let total = sum(high.high, high.low + low.high);
        sum(total.high, total.low + low.low)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let leading = product(self.high, other.high);
        sum(leading.high, leading.low + (self.high * other.low + self.low * other.high))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = Self::from(self.high / other.high);
        let rest = self - first * other;
        let second = Self::from(rest.high / other.high);
        let rest = rest - second * other;
        first + second + Self::from(rest.high / other.high)
    }
}

impl Scalar for DoubleDouble {
    fn from_constant(value: f64) -> Self {
        Self::from(value)
    }

    fn square_root(self) -> Self {
        if self.high == 0.0 {
            return self;
        }
        let first = Self::from(self.high.sqrt());
        first + Self::from((self - first * first).high / (2.0 * first.high))
    }
}

#[test]
fn twice_as_many_digits_as_f64_are_kept() {
    let number = |x: f64| DoubleDouble::from(x);
    let third = number(1.0) / number(3.0);
    let one = third + third + third;
    assert!((one - number(1.0)).value().abs() < 1e-31);
    let root = number(2.0).square_root();
    assert!((root * root - number(2.0)).value().abs() < 1e-31);
    let small = number(1.0) + number(1e-25) - number(1.0);
    assert!((small.value() / 1e-25 - 1.0).abs() < 1e-5);
}
