//! Functions of real numbers: square roots are nodes, sines and cosines of little inputs, the others are computed of constants alone.

use std::f64::consts;

use nalgebra::{ComplexField, RealField};
use num_traits::{One, Signed, Zero};

use crate::Traced;
use crate::tape::{Function, write};

/// Functions of one number that no node stands for.
macro_rules! functions {
    ($($name:ident)*) => {
        $(
            fn $name(self) -> Self {
                self.function(stringify!($name), f64::$name)
            }
        )*
    };
}

/// Constants.
macro_rules! constants {
    ($($name:ident $value:ident)*) => {
        $(
            fn $name() -> Self {
                Self::number(consts::$value)
            }
        )*
    };
}

impl ComplexField for Traced {
    type RealField = Self;

    functions! {
        floor ceil round trunc fract tan asin acos atan sinh cosh tanh
        asinh acosh atanh log2 log10 ln ln_1p exp exp2 exp_m1 cbrt
    }

    fn from_real(re: Self) -> Self {
        re
    }

    fn real(self) -> Self {
        self
    }

    fn imaginary(self) -> Self {
        Self::zero()
    }

    fn modulus(self) -> Self {
        Signed::abs(&self)
    }

    fn modulus_squared(self) -> Self {
        self * self
    }

    fn argument(self) -> Self {
        if self >= Self::zero() { Self::zero() } else { Self::pi() }
    }

    fn norm1(self) -> Self {
        Signed::abs(&self)
    }

    fn scale(self, factor: Self) -> Self {
        self * factor
    }

    fn unscale(self, factor: Self) -> Self {
        self / factor
    }

    fn abs(self) -> Self {
        Signed::abs(&self)
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    fn hypot(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }

    fn recip(self) -> Self {
        Self::one() / self
    }

    fn conjugate(self) -> Self {
        self
    }

    fn sin(self) -> Self {
        self.call("sin", Function::Sine)
    }

    fn cos(self) -> Self {
        self.call("cos", Function::Cosine)
    }

    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }

    fn sqrt(self) -> Self {
        Self { node: write(|tape| tape.graph.square_root(self.node)), value: self.value.sqrt() }
    }

    fn try_sqrt(self) -> Option<Self> {
        (self >= Self::zero()).then(|| self.sqrt())
    }

    fn powi(self, exponent: i32) -> Self {
        let power = (0..exponent.unsigned_abs()).fold(Self::one(), |power, _| power * self);
        if exponent < 0 { power.recip() } else { power }
    }

    fn powf(self, exponent: Self) -> Self {
        if exponent.is_number() {
            self.function("powf", |base| base.powf(exponent.value))
        } else {
            Self::missing("powf")
        }
    }

    fn powc(self, exponent: Self) -> Self {
        self.powf(exponent)
    }

    fn log(self, base: Self) -> Self {
        if base.is_number() { self.function("log", |x| x.log(base.value)) } else { Self::missing("log") }
    }

    fn is_finite(&self) -> bool {
        self.ask_finite()
    }
}

impl RealField for Traced {
    constants! {
        pi PI two_pi TAU frac_pi_2 FRAC_PI_2 frac_pi_3 FRAC_PI_3 frac_pi_4 FRAC_PI_4 frac_pi_6 FRAC_PI_6
        frac_pi_8 FRAC_PI_8 frac_1_pi FRAC_1_PI frac_2_pi FRAC_2_PI frac_2_sqrt_pi FRAC_2_SQRT_PI e E
        log2_e LOG2_E log10_e LOG10_E ln_2 LN_2 ln_10 LN_10
    }

    fn is_sign_positive(&self) -> bool {
        *self >= Self::zero()
    }

    fn is_sign_negative(&self) -> bool {
        *self < Self::zero()
    }

    fn copysign(self, sign: Self) -> Self {
        let size = Signed::abs(&self);
        if sign < Self::zero() { -size } else { size }
    }

    fn max(self, other: Self) -> Self {
        if self >= other { self } else { other }
    }

    fn min(self, other: Self) -> Self {
        if self <= other { self } else { other }
    }

    fn clamp(self, min: Self, max: Self) -> Self {
        if self < min {
            min
        } else if self > max {
            max
        } else {
            self
        }
    }

    fn atan2(self, other: Self) -> Self {
        if other.is_number() {
            self.function("atan2", |y| y.atan2(other.value))
        } else {
            Self::missing("atan2")
        }
    }

    fn min_value() -> Option<Self> {
        Some(Self::number(f64::MIN))
    }

    fn max_value() -> Option<Self> {
        Some(Self::number(f64::MAX))
    }
}
