//! Operators.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

use crate::Traced;
use crate::tape::write;

/// An operator with its assignment, and the node that it writes.
macro_rules! operator {
    ($operator:ident $method:ident, $assign:ident $assign_method:ident, $node:ident) => {
        impl $operator for Traced {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self {
                    node: write(|tape| tape.graph.$node(self.node, other.node)),
                    value: self.value.$method(other.value),
                }
            }
        }

        impl $assign for Traced {
            fn $assign_method(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    };
}

operator!(Add add, AddAssign add_assign, add);
operator!(Sub sub, SubAssign sub_assign, subtract);
operator!(Mul mul, MulAssign mul_assign, multiply);
operator!(Div div, DivAssign div_assign, divide);

impl Neg for Traced {
    type Output = Self;

    fn neg(self) -> Self {
        Self { node: write(|tape| tape.graph.negate(self.node)), value: -self.value }
    }
}

impl Rem for Traced {
    type Output = Self;

    fn rem(self, other: Self) -> Self {
        if self.is_number() && other.is_number() {
            Self::number(self.value % other.value)
        } else {
            Self::missing("remainder")
        }
    }
}

impl RemAssign for Traced {
    fn rem_assign(&mut self, other: Self) {
        *self = self.rem(other);
    }
}
