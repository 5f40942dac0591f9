//! Registers of several numbers, as far as the kernels need them.

use core::ops::{Add, Mul, Sub};

use wide::{f32x4, f32x8, f64x4, f64x8};

/// `W` numbers in a register.
pub trait Lanes<T, const W: usize>:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// The numbers in a register like this one, one per lane.
    fn like(self, numbers: &[T; W]) -> Self;
    /// The lanes as numbers.
    fn store(self) -> [T; W];
    /// `self * factor + term`, fused where the target does that in hardware.
    fn multiply_add(self, factor: Self, term: Self) -> Self;
    /// `term - self * factor`, fused where the target does that in hardware.
    fn subtract_from(self, factor: Self, term: Self) -> Self;
    /// The sum of the lanes.
    fn sum(self) -> T;

    /// The lanes moved down by `by`: lane k becomes what lane (k + by) mod W was.
    #[inline(always)]
    fn rotate(self, by: usize) -> Self
    where
        T: Copy,
    {
        let lanes = self.store();
        self.like(&core::array::from_fn(|k| lanes[(k + by) % W]))
    }
}

/// A register that the target has which the code is compiled for.
pub trait Everywhere<T, const W: usize>: Lanes<T, W> {
    /// The numbers, one per lane.
    fn load(numbers: &[T; W]) -> Self;
    /// One number in every lane.
    fn splat(number: T) -> Self;
}

/// A register of four lanes, the group in which sums over modes are taken.
pub trait Four<T>: Lanes<T, 4> {
    /// The four registers as rows of a matrix, transposed.
    fn transpose(rows: [Self; 4]) -> [Self; 4];

    /// The sum of the lanes of each of four registers: neighbours first, two registers at a time.
    #[inline(always)]
    fn sums(registers: [Self; 4]) -> [T; 4]
    where
        T: Copy,
    {
        let neighbours = |left: Self, right: Self| {
            let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (left.store(), right.store());
            (left.like(&[a0, b0, a2, b2]) + left.like(&[a1, b1, a3, b3])).store()
        };
        let [a, b, c, d] = registers;
        let ([a0, b0, a2, b2], [c0, d0, c2, d2]) = (neighbours(a, b), neighbours(c, d));
        (a.like(&[a0, b0, c0, d0]) + a.like(&[a2, b2, c2, d2])).store()
    }
}

/// The register type of `W` lanes of a scalar.
pub trait HasLanes<const W: usize>: Sized {
    /// The register.
    type Lanes: Everywhere<Self, W>;
}

macro_rules! lanes {
    ($($register:ty: $scalar:ty, $count:literal;)*) => {$(
        impl HasLanes<$count> for $scalar {
            type Lanes = $register;
        }

        impl Lanes<$scalar, $count> for $register {
            #[inline(always)]
            fn like(self, numbers: &[$scalar; $count]) -> Self {
                Self::new(*numbers)
            }

            #[inline(always)]
            fn store(self) -> [$scalar; $count] {
                self.to_array()
            }

            #[inline(always)]
            fn multiply_add(self, factor: Self, term: Self) -> Self {
                self.mul_add(factor, term)
            }

            #[inline(always)]
            fn subtract_from(self, factor: Self, term: Self) -> Self {
                self.mul_neg_add(factor, term)
            }

            #[inline(always)]
            fn sum(self) -> $scalar {
                self.reduce_add()
            }
        }

        impl Everywhere<$scalar, $count> for $register {
            #[inline(always)]
            fn load(numbers: &[$scalar; $count]) -> Self {
                Self::new(*numbers)
            }

            #[inline(always)]
            fn splat(number: $scalar) -> Self {
                Self::new([number; $count])
            }
        }
    )*};
}

lanes! {
    f64x4: f64, 4;
    f64x8: f64, 8;
    f32x4: f32, 4;
    f32x8: f32, 8;
}

impl Four<f64> for f64x4 {
    #[inline(always)]
    fn transpose(rows: [Self; 4]) -> [Self; 4] {
        Self::transpose(rows)
    }
}

impl Four<f32> for f32x4 {
    #[inline(always)]
    fn transpose(rows: [Self; 4]) -> [Self; 4] {
        Self::transpose(rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_move_and_add_up() {
        let lanes = f64x8::load(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
        assert_eq!(lanes.rotate(3).store(), [3.0, 4.0, 5.0, 6.0, 7.0, 0.0, 1.0, 2.0]);
        assert_eq!(Lanes::<f64, 8>::sum(lanes), 28.0);
        let row = |start: f32| f32x4::new([start, start + 1.0, start + 2.0, start + 3.0]);
        assert_eq!(Four::sums([row(0.0), row(4.0), row(8.0), row(12.0)]), [6.0, 22.0, 38.0, 54.0]);
        let two = f64x4::splat(2.0);
        assert_eq!(two.subtract_from(two, f64x4::splat(5.0)).store(), [1.0; 4]);
        assert_eq!(two.multiply_add(two, f64x4::splat(5.0)).store(), [9.0; 4]);
    }
}
