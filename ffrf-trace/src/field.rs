//! What makes it a number to nalgebra: zero and one, conversions, closeness.

use approx::{AbsDiffEq, RelativeEq, UlpsEq};
use nalgebra::Field;
use num_traits::{FromPrimitive, Num, One, ParseFloatError, Signed, Zero};
use simba::scalar::SubsetOf;

use crate::Traced;

impl Zero for Traced {
    fn zero() -> Self {
        Self::number(0.0)
    }

    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Traced {
    fn one() -> Self {
        Self::number(1.0)
    }
}

impl Num for Traced {
    type FromStrRadixErr = ParseFloatError;

    fn from_str_radix(text: &str, radix: u32) -> Result<Self, ParseFloatError> {
        f64::from_str_radix(text, radix).map(Self::number)
    }
}

impl FromPrimitive for Traced {
    fn from_i64(number: i64) -> Option<Self> {
        f64::from_i64(number).map(Self::number)
    }

    fn from_u64(number: u64) -> Option<Self> {
        f64::from_u64(number).map(Self::number)
    }

    fn from_f64(number: f64) -> Option<Self> {
        Some(Self::number(number))
    }
}

impl Signed for Traced {
    fn abs(&self) -> Self {
        if *self < Self::zero() { -*self } else { *self }
    }

    fn abs_sub(&self, other: &Self) -> Self {
        if *self <= *other { Self::zero() } else { *self - *other }
    }

    fn signum(&self) -> Self {
        if *self < Self::zero() { -Self::one() } else { Self::one() }
    }

    fn is_positive(&self) -> bool {
        *self > Self::zero()
    }

    fn is_negative(&self) -> bool {
        *self < Self::zero()
    }
}

impl Field for Traced {}

impl SubsetOf<Self> for Traced {
    fn to_superset(&self) -> Self {
        *self
    }

    fn from_superset_unchecked(element: &Self) -> Self {
        *element
    }

    fn is_in_subset(_: &Self) -> bool {
        true
    }
}

/// Plain numbers are traced ones; the way back is open to what is the same in every run.
macro_rules! plain {
    ($number:ty) => {
        impl SubsetOf<Traced> for $number {
            fn to_superset(&self) -> Traced {
                Traced::number(f64::from(*self))
            }

            fn from_superset_unchecked(element: &Traced) -> Self {
                element.value as Self
            }

            fn is_in_subset(element: &Traced) -> bool {
                element.is_number()
            }
        }
    };
}

plain!(f64);
plain!(f32);

impl AbsDiffEq for Traced {
    type Epsilon = Self;

    fn default_epsilon() -> Self {
        Self::number(f64::EPSILON)
    }

    fn abs_diff_eq(&self, other: &Self, epsilon: Self) -> bool {
        Signed::abs(&(*self - *other)) <= epsilon
    }
}

impl RelativeEq for Traced {
    fn default_max_relative() -> Self {
        Self::number(f64::EPSILON)
    }

    fn relative_eq(&self, other: &Self, epsilon: Self, max_relative: Self) -> bool {
        let difference = Signed::abs(&(*self - *other));
        let largest = nalgebra::RealField::max(Signed::abs(self), Signed::abs(other));
        difference <= epsilon || difference <= largest * max_relative
    }
}

impl UlpsEq for Traced {
    fn default_max_ulps() -> u32 {
        4
    }

    fn ulps_eq(&self, other: &Self, epsilon: Self, max_ulps: u32) -> bool {
        self.relative_eq(other, epsilon, Self::number(f64::from(max_ulps) * f64::EPSILON))
    }
}
