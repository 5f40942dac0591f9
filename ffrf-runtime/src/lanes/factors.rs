//! Triangular factors of symmetric positive definite matrices in space.

use super::{Registers, Scalar};

/// S = L D Lᵀ, with ones on the diagonal of L.
///
/// A solution by these factors is that of a matrix within rounding of S, entry by entry, whatever the condition number;
/// a product with S⁻¹ is not.
#[derive(Debug, Clone, Copy)]
pub struct Factors<C> {
    /// 1 / D.
    pub inverse_pivots: [C; 3],
    /// L_yx, L_zx, L_zy; `None` for a diagonal matrix.
    pub lower: Option<[C; 3]>,
}

impl<T: Scalar> Factors<T> {
    /// The factors of S: xx, yy, zz, xy, xz, yz. S must be positive definite; otherwise they are of no use.
    ///
    /// Rows are multiplied by pivots instead of divided, so that no division waits for another. `scale` is about one
    /// over the size of the entries, to any accuracy: without it the last pivot is of their fourth power, which f32 does
    /// not hold for a body of a gram and a millimetre.
    #[inline(always)]
    pub(super) fn new<R: Registers<T>>(registers: R, [xx, yy, zz, xy, xz, yz]: [T; 6], scale: T) -> Self {
        let first = T::one() / xx;
        let [pivot, scaled_y, scaled_z] = [xx, xy, xz].map(|entry| entry * scale);
        let yy = registers.multiply_add(pivot, yy, -(scaled_y * xy));
        let yz = registers.multiply_add(pivot, yz, -(scaled_y * xz));
        let zz = registers.multiply_add(pivot, zz, -(scaled_z * xz));
        let second = T::one() / yy;
        let third = T::one() / registers.multiply_add(yy, zz, -(yz * yz));
        Self {
            inverse_pivots: [first, pivot * second, pivot * yy * third],
            lower: Some([xy * first, xz * first, yz * second]),
        }
    }
}

impl<C: Copy> Factors<C> {
    /// The same in another number type.
    #[inline(always)]
    pub(super) fn map<T>(self, change: impl Fn(C) -> T) -> Factors<T> {
        Factors {
            inverse_pivots: self.inverse_pivots.map(&change),
            lower: self.lower.map(|lower| lower.map(&change)),
        }
    }
}

impl<T: Scalar> Factors<T> {
    /// L⁻¹ v
    #[inline(always)]
    pub(super) fn forward<R: Registers<T>>(&self, registers: R, [x, y, z]: [T; 3]) -> [T; 3] {
        let Some([yx, zx, zy]) = self.lower else { return [x, y, z] };
        let y = registers.multiply_add(-yx, x, y);
        [x, y, registers.multiply_add(-zy, y, registers.multiply_add(-zx, x, z))]
    }

    /// D⁻¹ v
    #[inline(always)]
    pub(super) fn weigh(&self, v: [T; 3]) -> [T; 3] {
        [0, 1, 2].map(|axis| v[axis] * self.inverse_pivots[axis])
    }

    /// L⁻ᵀ v
    #[inline(always)]
    pub(super) fn backward<R: Registers<T>>(&self, registers: R, [x, y, z]: [T; 3]) -> [T; 3] {
        let Some([yx, zx, zy]) = self.lower else { return [x, y, z] };
        let y = registers.multiply_add(-zy, z, y);
        [registers.multiply_add(-yx, y, registers.multiply_add(-zx, z, x)), y, z]
    }
}

/// S⁻¹ v for S: xx, yy, zz, xy, xz, yz. The elimination of [`Factors::new`], `scale` as there, with the right-hand side
/// along with the matrix, so that little is left to do behind the last division.
#[inline(always)]
pub(super) fn solve_with_divisions_deferred<T: Scalar, R: Registers<T>>(
    registers: R,
    [xx, yy, zz, xy, xz, yz]: [T; 6],
    scale: T,
    [x, y, z]: [T; 3],
) -> [T; 3] {
    let [pivot, scaled_y, scaled_z] = [xx, xy, xz].map(|entry| entry * scale);
    let yy = registers.multiply_add(pivot, yy, -(scaled_y * xy));
    let yz = registers.multiply_add(pivot, yz, -(scaled_y * xz));
    let zz = registers.multiply_add(pivot, zz, -(scaled_z * xz));
    let y = registers.multiply_add(pivot, y, -(scaled_y * x));
    let z = registers.multiply_add(pivot, z, -(scaled_z * x));
    let [first, second] = [xx, yy].map(|pivot| T::one() / pivot);
    let third = T::one() / registers.multiply_add(yy, zz, -(yz * yz));
    let z = registers.multiply_add(yy, z, -(yz * y)) * third;
    // Rows are divided before the unknowns to the right are known: one operation a row is left to wait for.
    let [y, yz] = [y, yz].map(|entry| entry * second);
    let [x, xz, xy] = [x, xz, xy].map(|entry| entry * first);
    let y = registers.multiply_add(-yz, z, y);
    [registers.multiply_add(-xy, y, registers.multiply_add(-xz, z, x)), y, z]
}

#[cfg(test)]
mod tests {
    use super::super::Compiled;
    use super::super::rigid::{subtract, times};
    use super::*;

    #[test]
    fn the_matrix_times_a_solution_is_the_right_hand_side() {
        let matrix = [4.0, 5.0, 6.0, 0.5, -0.25, 1.0];
        for scale in [1e-3, 1.0, 1e3] {
            let factors = Factors::new(Compiled, matrix, scale);
            for axis in 0..3 {
                let unit: [f64; 3] = core::array::from_fn(|i| if i == axis { 1.0 } else { 0.0 });
                let by_factors = factors.backward(Compiled, factors.weigh(factors.forward(Compiled, unit)));
                for solution in [by_factors, solve_with_divisions_deferred(Compiled, matrix, scale, unit)] {
                    let back = times(Compiled, matrix, solution);
                    assert!(subtract(back, unit).iter().all(|x| x.abs() < 4.0 * f64::EPSILON), "{back:?}");
                }
            }
        }
    }

    #[test]
    fn a_matrix_far_from_one_is_factorised_in_f32() {
        // A cube of a gram and a millimetre, and a ship.
        for size in [1e-10_f32, 1e12] {
            let matrix = [size, 2.0 * size, 3.0 * size, 0.1 * size, 0.0, 0.2 * size];
            let factors = Factors::new(Compiled, matrix, 1.0 / size);
            let by_factors = factors.backward(Compiled, factors.weigh(factors.forward(Compiled, [size; 3])));
            for solution in
                [by_factors, solve_with_divisions_deferred(Compiled, matrix, 1.0 / size, [size; 3])]
            {
                assert!(solution.iter().all(|x| x.is_finite() && *x > 0.1), "{size}: {solution:?}");
            }
        }
    }
}
